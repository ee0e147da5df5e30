using System.Globalization;
using Engraver.Core.Geometry;

namespace Engraver.TestKit;

/// <summary>A simple reader of tab-separated sequential programs for tests: everything that can be read is followed, without checks, and the path is computed
/// separately.</summary>
public static class TabProgram
{
    /// <summary>The path of every block from a start point, millimetres, and whether it cuts; null when a number cannot be read.</summary>
    public static IReadOnlyList<(Segment Path, bool Cutting)>? Paths(string text, Point2D start)
    {
        var (paths, place) = (new List<(Segment, bool)>(), start);
        foreach (var row in text.Split('\n').Where(row => row.Contains('\t', StringComparison.Ordinal)))
        {
            var fields = row.Split('\t');
            if (fields.Length < 8 || !fields[2..8].All(field => int.TryParse(field, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out _))) return null;
            var numbers = fields[2..8].Select(field => int.Parse(field, CultureInfo.InvariantCulture)).ToArray();
            var path = numbers[0] == 1 ? Segment.FromLine(place, place + new Vector2D(numbers[3] / 1000.0, numbers[4] / 1000.0)) : Arc(place, numbers[3] / 1000.0, numbers[1], numbers[0] == 2 ? -numbers[2] : numbers[2]);
            paths.Add((path, numbers[5] == 2));
            place = path.End;
        }

        return paths;
    }

    /// <summary>The largest distance of points on some segments from others, millimetres.</summary>
    public static double Farthest(IReadOnlyList<Segment> from, IReadOnlyList<Segment> to, double step)
    {
        var largest = 0.0;
        foreach (var segment in from)
        {
            var places = Math.Max(8, (int)Math.Ceiling(segment.Length / step));
            for (var i = 0; i <= places; i++) largest = Math.Max(largest, to.Min(one => one.DistanceTo(segment.PointAt((double)i / places))));
        }

        return largest;
    }

    private static Segment Arc(Point2D place, double radius, int start, int sweep)
    {
        var turned = start * Math.PI / 180.0;
        return Segment.FromArc(new ArcSegment(new Point2D(place.X - (radius * Math.Cos(turned)), place.Y - (radius * Math.Sin(turned))), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep)));
    }
}
