using Engraver.Core.Geometry;

namespace Engraver.Core.Trajectories;

/// <summary>The uniform Catmull-Rom spline that a controller runs through a trajectory's points: the tangent at a point is half the vector from its predecessor
/// to its successor (paper 004; sace-xps-agie.md 2.3).</summary>
internal sealed class CatmullRomSpline
{
    private readonly Point2D[] _lines;

    /// <param name="lines">Points as in the file: a phantom point, the visited points, a phantom point.</param>
    public CatmullRomSpline(Point2D[] lines)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(lines.Length, 4);
        _lines = lines;
    }

    /// <summary>Phantom point, visited points, phantom point.</summary>
    public IReadOnlyList<Point2D> Lines => _lines;

    /// <summary>Number of cubics.</summary>
    public int Count => _lines.Length - 3;

    /// <summary>A cubic by its four Bezier control points.</summary>
    public Cubic this[int segment]
    {
        get
        {
            var (before, start, end, after) = (_lines[segment], _lines[segment + 1], _lines[segment + 2], _lines[segment + 3]);
            return new Cubic(start, start + ((end - before) * (1.0 / 6.0)), end - ((after - start) * (1.0 / 6.0)), end);
        }
    }

    /// <summary>Largest ratio of two neighbouring chords; 1 for a single chord.</summary>
    public double SpacingRatio(bool closed)
    {
        var ratio = 1.0;
        for (var i = 0; i < (closed ? Count : Count - 1); i++)
        {
            var (one, other) = (Chord(i), Chord((i + 1) % Count));
            ratio = Math.Max(ratio, Math.Max(one / other, other / one));
        }

        return ratio;
    }

    public double Chord(int segment) => _lines[segment + 1].DistanceTo(_lines[segment + 2]);
}
