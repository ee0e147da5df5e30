using Engraver.Core.Geometry;

namespace Engraver.Galil.Programs;

/// <summary>An arc as chords, for what CR cannot cut.</summary>
internal static class ArcChords
{
    /// <summary>Inner vertices and end of the chords whose sagitta stays within <paramref name="maxError"/> (same unit as the arc).</summary>
    public static IEnumerable<Point2D> Vertices(ArcSegment arc, double maxError)
    {
        var count = Count(arc, maxError);
        for (var i = 1; i < count; i++) yield return arc.PointAt((double)i / count);
        yield return arc.EndPoint;
    }

    private static int Count(ArcSegment arc, double maxError)
    {
        var step = 2.0 * Math.Acos(1.0 - Math.Min(maxError / arc.Radius, 1.0));
        var least = arc.IsFullTurn ? 3 : 1;
        return Math.Max(least, (int)Math.Ceiling(Math.Abs(arc.Sweep.Radians) / step));
    }
}
