using Engraver.Core.Geometry;

namespace Engraver.Core.Pockets;

/// <summary>Entry of the tool to the depth of a stroke.</summary>
public enum PocketEntry
{
    /// <summary>Straight down.</summary>
    Plunge,

    /// <summary>Down along the first pass: around it when it is closed, back and forth when it is open.</summary>
    Ramp,

    /// <summary>Down on a helix next to the start of the first pass; without room for a helix, as <see cref="Ramp"/>.</summary>
    Helix,
}

/// <summary>Depths of a pocket. Lengths in millimetres.</summary>
public sealed record PocketDepths
{
    /// <summary>All at height 0, with no entry: the machine profile sets the cutting depth.</summary>
    public static PocketDepths Flat { get; } = new();

    /// <summary>Depth below the top of the work (height 0), 0 or more.</summary>
    public double Depth { get; init; }

    /// <summary>Maximum depth of one level; the levels divide the depth evenly. 0 for one level.</summary>
    public double Step { get; init; }

    public PocketEntry Entry { get; init; } = PocketEntry.Plunge;

    /// <summary>Angle of descent of a ramp or helix, above 0 and below 90 degrees.</summary>
    public Angle RampAngle { get; init; } = Angle.FromDegrees(3.0);

    /// <summary>Heights of the levels, from the top down; only 0 for a flat pocket.</summary>
    public IReadOnlyList<double> Heights
    {
        get
        {
            var count = Depth > 0.0 && Step > 0.0 ? Math.Max(1, (int)Math.Ceiling(Depth / Step * (1.0 - 1e-12))) : 1;
            return [.. Enumerable.Range(1, count).Select(level => -Depth * level / count)];
        }
    }
}

/// <summary>A stroke at its height, and the descent to it.</summary>
/// <param name="Stroke">Level, at <paramref name="Z"/>.</param>
/// <param name="Z">Height, 0 at the top of the work, negative into it.</param>
/// <param name="Way">Points of the descent with their heights, ending at the start of the stroke; empty for straight down.</param>
/// <param name="Entry">Type of the descent: a ramp where a helix has no room.</param>
public sealed record PocketCut(PocketStroke Stroke, double Z, IReadOnlyList<(Point2D Place, double Z)> Way, PocketEntry Entry);
