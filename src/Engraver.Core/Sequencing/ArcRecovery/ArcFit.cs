using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.ArcRecovery;

/// <summary>Fits the nearest circle (least squares) to vertices; <see cref="ChordProof"/> proves the fit.</summary>
internal static class ArcFit
{
    /// <summary>An arc that rises less than this many times the error above its chord is nearly straight, and its lines stay as drawn.</summary>
    private const double MinRise = 2.0;

    /// <summary>Degrees. Vertices that are nearer to a full turn without closing stay as two arcs.</summary>
    private const double MaxSweep = 350.0;

    /// <summary>True when an arc rises enough above its chord.</summary>
    public static bool Rises(in RecoveredArc found, double maxError) =>
        found.Arc.Radius * (1.0 - Math.Cos(Math.Min(Math.PI, found.Arc.Sweep.Abs().Radians / 2.0))) >= MinRise * maxError;

    /// <summary>The arc from the first vertex to the last, both kept exactly; null when there is no arc within the error.</summary>
    public static RecoveredArc? Arc(ReadOnlySpan<Point2D> vertices, in ChordTolerances tolerances)
    {
        var (start, end) = (vertices[0], vertices[^1]);
        var chord = end - start;
        var half = chord.Length / 2.0;
        if (!(half > 0.0)) return null;
        var along = chord * (0.5 / half);
        var left = new Vector2D(-along.Y, along.X);
        var middle = start + (chord * 0.5);
        if (CentreHeight(vertices, middle, along, left, half) is not { } found) return null;
        var (height, side) = found;
        var radius = double.Hypot(half, height);
        var centre = middle + (left * height);
        var sweep = Angle.FromRadians(-side * 2.0 * Math.Atan2(half, -side * height));
        if (Math.Abs(sweep.Degrees) > MaxSweep || !new ChordProof(centre, radius, -side, tolerances).IsProven(vertices, closed: false, out var deviation, out var length)) return null;
        var arc = new ArcSegment(centre, radius, (start - centre).Direction.Positive(), sweep);
        return IsOnce(length, arc) ? new RecoveredArc(arc, start, end, deviation) : null;
    }

    /// <summary>The full circle of a closed polygon; null when it is not a circle.</summary>
    public static RecoveredArc? Circle(ReadOnlySpan<Point2D> vertices, in ChordTolerances tolerances)
    {
        var origin = vertices[0];
        double x = 0, y = 0, area = 0;
        var last = vertices[^1] - origin;
        foreach (var vertex in vertices)
        {
            var way = vertex - origin;
            (x, y, area) = (x + way.X, y + way.Y, area + last.Cross(way));
            last = way;
        }

        var mean = origin + (new Vector2D(x, y) * (1.0 / vertices.Length));
        if (Centre(vertices, mean) is not { } centre) return null;
        var radius = 0.0;
        foreach (var vertex in vertices) radius += vertex.DistanceTo(centre) / vertices.Length;
        var turn = area < 0.0 ? -1.0 : 1.0;
        if (!(radius > MinRise * tolerances.MaxError) || !new ChordProof(centre, radius, turn, tolerances).IsProven(vertices, closed: true, out var deviation, out var length)) return null;
        var circle = new ArcSegment(centre, radius, Angle.Zero, Angle.FullTurn * turn);
        return IsOnce(length, circle) ? new RecoveredArc(circle, circle.StartPoint, circle.StartPoint, deviation) : null;
    }

    /// <summary>Height of the centre of the best circle through both ends above the chord's middle (left positive), and the side of the vertices (left
    /// +1).</summary>
    private static (double Height, double Side)? CentreHeight(ReadOnlySpan<Point2D> vertices, Point2D middle, Vector2D along, Vector2D left, double half)
    {
        double mixed = 0, squared = 0, sum = 0;
        foreach (var vertex in vertices[1..^1])
        {
            var way = vertex - middle;
            var (x, y) = (way.Dot(along), way.Dot(left));
            mixed += ((x * x) + (y * y) - (half * half)) * y;
            squared += y * y;
            sum += y;
        }

        var height = mixed / (2.0 * squared);
        return double.IsFinite(height) ? (height, sum < 0.0 ? -1.0 : 1.0) : null;
    }

    /// <summary>Kasa's fit: least squares of x^2 + y^2 against x, y and 1, about the mean of the vertices.</summary>
    private static Point2D? Centre(ReadOnlySpan<Point2D> vertices, Point2D mean)
    {
        double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
        foreach (var vertex in vertices)
        {
            var (x, y) = (vertex.X - mean.X, vertex.Y - mean.Y);
            var z = (x * x) + (y * y);
            (xx, xy, yy, xz, yz) = (xx + (x * x), xy + (x * y), yy + (y * y), xz + (x * z), yz + (y * z));
        }

        var determinant = 2.0 * ((xx * yy) - (xy * xy));
        var centre = mean + new Vector2D(((xz * yy) - (yz * xy)) / determinant, ((yz * xx) - (xz * xy)) / determinant);
        return centre.IsFinite ? centre : null;
    }

    /// <summary>True when the chords turn as far as the arc and not a full turn more.</summary>
    private static bool IsOnce(double length, in ArcSegment arc) => Math.Abs(length - arc.Length) < arc.Radius;
}

/// <summary>An arc or circle that replaces straight pieces of a contour.</summary>
/// <param name="Arc">A sweep of exactly +-360 degrees is a full circle.</param>
/// <param name="Start">Exactly where the first piece starts.</param>
/// <param name="End">Exactly where the last piece ends.</param>
/// <param name="Deviation">Largest distance between the pieces and the arc, in both directions, mm.</param>
internal readonly record struct RecoveredArc(ArcSegment Arc, Point2D Start, Point2D End, double Deviation);
