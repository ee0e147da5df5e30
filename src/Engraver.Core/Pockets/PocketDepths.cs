using Engraver.Core.Geometry;

namespace Engraver.Core.Pockets;

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
