using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Overlays;

/// <summary>What the overlay shows besides the prepared job. Each input is optional.</summary>
public sealed record OverlayInputs
{
    public static OverlayInputs None { get; } = new();

    /// <summary>Planned speed of each cutting move in cutting order, as a fraction of the fastest (0 to 1); missing values count as fastest.</summary>
    public IReadOnlyList<double> MoveSpeeds { get; init; } = [];

    /// <summary>Computes <see cref="MoveSpeeds"/> when they are first shown; null if they are known.</summary>
    public Func<IReadOnlyList<double>>? LazyMoveSpeeds { get; init; }

    /// <summary>Points of the findings of CHECK, drawing units; the discontinuities of the job need not be included.</summary>
    public IReadOnlyList<Point2D> Findings { get; init; } = [];

    /// <summary>The machine travel, drawing units; null if unknown.</summary>
    public Bounds2D? MachineEnvelope { get; init; }

    /// <summary>Work origin in the drawing; null if unknown.</summary>
    public Point2D? WorkOrigin { get; init; }

    /// <summary>Position of the machine after the last stroke, drawing units; null if it stays, or if the position is unknown.</summary>
    public Point2D? Finish { get; init; }

    public IReadOnlyList<RecordedPlace> Recorded { get; init; } = [];
}
