using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Approximates an arc that CR cannot cut by chords.</summary>
internal static class ArcChords
{
    /// <summary>Chords with a smaller sagitta, counts, give no improvement, because their vertices are whole counts.</summary>
    private const double FinestSagitta = 0.25;

    /// <summary>Allowed distance of chords from the arc, millimetres: as requested, but not finer than counts can represent.</summary>
    public static double ErrorOf(double wantedMm, CountsScale scale) => Math.Max(wantedMm, scale.Finer.LengthOf(FinestSagitta));

    /// <summary>Inner vertices and end of the chords whose sagitta is at most <paramref name="maxError"/> (same unit as the arc).</summary>
    public static IEnumerable<Point2D> Vertices(ArcSegment arc, double maxError)
    {
        var count = Count(arc, maxError);
        for (var i = 1; i < count; i++) yield return arc.PointAt(i / count);
        yield return arc.EndPoint;
    }

    /// <summary>Number of these chords, a whole number; for a huge arc more than an integer can hold.</summary>
    public static double Count(ArcSegment arc, double maxError)
    {
        // 1 - cos(half angle) = e, solved with the sine of a quarter, which keeps its digits when the error is tiny compared with the radius.
        var step = 4.0 * Math.Asin(Math.Sqrt(Math.Min(maxError / arc.Radius, 1.0) / 2.0));
        var least = arc.IsFullTurn ? 3.0 : 1.0;
        return Math.Max(least, Math.Ceiling(Math.Abs(arc.Sweep.Radians) / step));
    }
}
