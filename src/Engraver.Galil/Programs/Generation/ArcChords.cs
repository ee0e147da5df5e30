using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Generation;

/// <summary>An arc as chords, for what CR cannot cut.</summary>
internal static class ArcChords
{
    /// <summary>Chords finer than this gain nothing, because their vertices are whole counts.</summary>
    private const double FinestSagitta = 0.25;

    /// <summary>How far chords may leave the arc, millimetres: what is wanted, but no finer than the counts can show.</summary>
    public static double ErrorOf(double wantedMm, CountsScale scale) => Math.Max(wantedMm, FinestSagitta / scale.Largest);

    /// <summary>Inner vertices and end of the chords whose sagitta stays within <paramref name="maxError"/> (same unit as the arc).</summary>
    public static IEnumerable<Point2D> Vertices(ArcSegment arc, double maxError)
    {
        var count = Count(arc, maxError);
        for (var i = 1; i < count; i++) yield return arc.PointAt(i / count);
        yield return arc.EndPoint;
    }

    /// <summary>How many chords that are, a whole number; for a huge arc more than an integer holds.</summary>
    public static double Count(ArcSegment arc, double maxError)
    {
        // The half angle whose cosine is 1 - e; its sine squared form keeps its digits when the error is tiny beside the radius.
        var step = 4.0 * Math.Asin(Math.Sqrt(Math.Min(maxError / arc.Radius, 1.0) / 2.0));
        var least = arc.IsFullTurn ? 3.0 : 1.0;
        return Math.Max(least, Math.Ceiling(Math.Abs(arc.Sweep.Radians) / step));
    }
}
