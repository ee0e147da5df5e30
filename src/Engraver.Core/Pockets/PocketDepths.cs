using Engraver.Core.Geometry;

namespace Engraver.Core.Pockets;

/// <summary>How the tool comes down to the depth of a stroke.</summary>
public enum PocketEntry
{
    /// <summary>Straight down.</summary>
    Plunge,

    /// <summary>Down along the first pass: round it when it is closed, there and back when it is not.</summary>
    Ramp,

    /// <summary>Down on a screw line beside the start of the first pass; where there is no room for one, as <see cref="Ramp"/>.</summary>
    Helix,
}

/// <summary>Depths of a pocket. Lengths in millimetres.</summary>
public sealed record PocketDepths
{
    /// <summary>All at height 0, with no entry: the machine profile says how deep it cuts.</summary>
    public static PocketDepths Flat { get; } = new();

    /// <summary>Below the top of the work (height 0), 0 or more.</summary>
    public double Depth { get; init; }

    /// <summary>Most that one level takes off; the levels divide the depth evenly. 0 for one level.</summary>
    public double Step { get; init; }

    public PocketEntry Entry { get; init; } = PocketEntry.Plunge;

    /// <summary>How steeply a ramp or screw line goes down, above 0 and below 90 degrees.</summary>
    public Angle RampAngle { get; init; } = Angle.FromDegrees(3.0);

    /// <summary>Heights of the levels, from the top down; 0 alone for a flat one.</summary>
    public IReadOnlyList<double> Heights
    {
        get
        {
            var count = Depth > 0.0 && Step > 0.0 ? Math.Max(1, (int)Math.Ceiling(Depth / Step * (1.0 - 1e-12))) : 1;
            return [.. Enumerable.Range(1, count).Select(level => -Depth * level / count)];
        }
    }
}

/// <summary>A stroke at its height, and the way down to it.</summary>
/// <param name="Stroke">Level, at <paramref name="Z"/>.</param>
/// <param name="Z">Height, 0 at the top of the work, negative into it.</param>
/// <param name="Way">Points of the way down with their heights, ending at the start of the stroke; empty for straight down.</param>
/// <param name="Entry">What the way is: a ramp where a screw line has no room.</param>
public sealed record PocketCut(PocketStroke Stroke, double Z, IReadOnlyList<(Point2D Place, double Z)> Way, PocketEntry Entry);
