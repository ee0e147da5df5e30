using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Overlays;

/// <summary>What the overlay shows besides the prepared job. Each may be missing.</summary>
public sealed record OverlayInputs
{
    public static OverlayInputs None { get; } = new();

    /// <summary>Planned speed of each cutting move in the order of cutting, as a part of the fastest (0 to 1); what is missing counts as fastest.</summary>
    public IReadOnlyList<double> MoveSpeeds { get; init; } = [];

    /// <summary>Computes <see cref="MoveSpeeds"/> when they are seen; null: they are known.</summary>
    public Func<IReadOnlyList<double>>? MoveSpeedsWhenSeen { get; init; }

    /// <summary>Places of the findings of CHECK, drawing units; the discontinuities of the job need not be among them.</summary>
    public IReadOnlyList<Point2D> Findings { get; init; } = [];

    /// <summary>How far the machine reaches, drawing units; null: not known.</summary>
    public Bounds2D? MachineEnvelope { get; init; }

    /// <summary>Drawing point of the work origin; null: not known.</summary>
    public Point2D? WorkOrigin { get; init; }

    /// <summary>Where the machine goes behind the last stroke, drawing units; null: it stays, or nobody knows.</summary>
    public Point2D? Finish { get; init; }

    public IReadOnlyList<RecordedPlace> Recorded { get; init; } = [];
}
