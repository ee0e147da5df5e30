using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.TestKit.Programs;

/// <summary>A simple reader of XPS trajectory texts for tests: everything that can be read is followed, without checks.</summary>
public static class TrajectoryLines
{
    private const int Chords = 24;

    /// <summary>The cuts, millimetres; null when a number cannot be read.</summary>
    /// <param name="target">xps-linearc, xps-spline or xps-pvt.</param>
    public static IReadOnlyList<Segment>? Cuts(string text, string target)
    {
        var (cuts, start, rows) = (new List<Segment>(), default(Point2D), new List<double[]>());
        foreach (var row in text.Split('\n').Append("; trajectory 0 0"))
        {
            if (row.StartsWith("; trajectory ", StringComparison.Ordinal))
            {
                cuts.AddRange(target switch { "xps-linearc" => LineArcs(start, rows), "xps-spline" => Spline(start, rows), _ => Pvt(start, rows) });
                rows.Clear();
                var words = row.Split(' ');
                if (!double.TryParse(words[2], CultureInfo.InvariantCulture, out var x) || !double.TryParse(words[^1], CultureInfo.InvariantCulture, out var y)) return null;
                start = new Point2D(x, y);
                continue;
            }

            var parts = row.Split(';')[0].Split('=');
            var key = parts.Length < 2 ? 0.0 : parts[0].Trim() switch { "FirstTangent" => 1.0, "Line" => 2.0, "Arc" => 3.0, _ => 4.0 };
            if (parts[^1].Trim().Length == 0) continue;
            var numbers = parts[^1].Split(',').Select(word => double.TryParse(word, CultureInfo.InvariantCulture, out var value) ? value : double.NaN).ToArray();
            if (numbers.Any(double.IsNaN)) return null;
            rows.Add([key, .. numbers]);
        }

        return cuts;
    }

    private static List<Segment> LineArcs(Point2D start, List<double[]> rows)
    {
        var (cuts, place, heading) = (new List<Segment>(), start, default(Angle));
        foreach (var row in rows)
        {
            if (row[0] == 1.0) heading = Angle.FromDegrees(row[1]);
            if (row[0] < 2.0 || row[0] > 3.0 || row.Length < 3) continue;
            var way = Vector2D.FromPolar(1.0, heading);
            var side = Math.Sign(row[2]);
            var centre = place + (new Vector2D(-way.Y, way.X) * (side * row[1]));
            var run = row[0] == 2.0 ? Segment.FromLine(place, new Point2D(start.X + row[1], start.Y + row[2])) : Segment.FromArc(new ArcSegment(centre, row[1], (place - centre).Direction, Angle.FromDegrees(row[2])));
            cuts.Add(run);
            (place, heading) = (run.End, run.EndTangent.Direction);
        }

        return cuts;
    }

    /// <summary>Catmull-Rom as Bezier: the inner points are a sixth of the neighbours' chord from the ends.</summary>
    private static List<Segment> Spline(Point2D start, List<double[]> rows)
    {
        var points = rows.Where(row => row.Length > 2).Select(row => new Point2D(start.X + row[1], start.Y + row[2])).ToList();
        return [.. Enumerable.Range(1, Math.Max(0, points.Count - 3)).SelectMany(i => Bezier(points[i], points[i] + ((points[i + 1] - points[i - 1]) * (1.0 / 6.0)), points[i + 1] + ((points[i + 2] - points[i]) * (-1.0 / 6.0)), points[i + 1]))];
    }

    private static List<Segment> Pvt(Point2D start, List<double[]> rows)
    {
        var (cuts, place, speed) = (new List<Segment>(), start, default(Vector2D));
        foreach (var row in rows.Where(row => row.Length == 6))
        {
            var (end, next) = (place + new Vector2D(row[2], row[4]), new Vector2D(row[3], row[5]));
            cuts.AddRange(Bezier(place, place + (speed * (row[1] / 3.0)), end + (next * (-row[1] / 3.0)), end));
            (place, speed) = (end, next);
        }

        return cuts;
    }

    private static IEnumerable<Segment> Bezier(Point2D a, Point2D b, Point2D c, Point2D d)
    {
        var last = a;
        for (var i = 1; i <= Chords; i++)
        {
            var (u, v) = ((double)i / Chords, 1.0 - ((double)i / Chords));
            double On(double p, double q, double r, double s) => (v * v * v * p) + (3.0 * v * v * u * q) + (3.0 * v * u * u * r) + (u * u * u * s);
            var next = new Point2D(On(a.X, b.X, c.X, d.X), On(a.Y, b.Y, c.Y, d.Y));
            yield return Segment.FromLine(last, next);
            last = next;
        }
    }
}
