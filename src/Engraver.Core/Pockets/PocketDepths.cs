using Engraver.Core.Geometry;

namespace Engraver.Core.Pockets;

/// <summary>Depths of a pocket. Lengths in millimetres.</summary>
public sealed record PocketDepths
{
    /// <summary>Depth below the top of the work (height 0), 0 or more; 0 when the machine profile sets the cutting depth.</summary>
    public required double Depth { get; init; }

    /// <summary>Maximum depth of one level; the levels divide the depth evenly. 0 for one level.</summary>
    public required double Step { get; init; }

    public required PocketEntry Entry { get; init; }

    /// <summary>Angle of descent of a ramp or helix, above 0 and below 90 degrees.</summary>
    public required Angle RampAngle { get; init; }

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
