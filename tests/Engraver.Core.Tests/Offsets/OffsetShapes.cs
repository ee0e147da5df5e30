using Engraver.Core.Geometry;
using Engraver.Core.Offsets;

namespace Engraver.Core.Tests.Offsets;

/// <summary>Contours to offset.</summary>
internal static class OffsetShapes
{
    public static OffsetContour Polygon(params (double X, double Y)[] corners) => Chain(closed: true, [.. corners.Select(corner => (corner.X, corner.Y, 0.0))]);

    public static OffsetContour Line(params (double X, double Y)[] corners) => Chain(closed: false, [.. corners.Select(corner => (corner.X, corner.Y, 0.0))]);

    /// <summary>Vertices with bulges, as in a polyline; the last bulge counts only when closed.</summary>
    public static OffsetContour Chain(bool closed, params (double X, double Y, double Bulge)[] vertices)
    {
        var segments = new List<Segment>();
        for (var i = 0; i + (closed ? 0 : 1) < vertices.Length; i++)
        {
            var (from, to) = (vertices[i], vertices[(i + 1) % vertices.Length]);
            var (start, end) = (new Point2D(from.X, from.Y), new Point2D(to.X, to.Y));
            segments.Add(from.Bulge == 0.0 ? Segment.FromLine(start, end) : Segment.FromArc(ArcSegment.FromBulge(start, end, from.Bulge), start, end));
        }

        return new OffsetContour(segments, closed);
    }

    public static OffsetContour Circle(double x, double y, double radius, bool clockwise = false) =>
        new([Segment.FromArc(new ArcSegment(new Point2D(x, y), radius, Angle.Zero, clockwise ? -Angle.FullTurn : Angle.FullTurn))], true);

    public static OffsetContour Rectangle(double x, double y, double width, double height) => Polygon((x, y), (x + width, y), (x + width, y + height), (x, y + height));

    /// <summary>A slot from 0,0 to length,0.</summary>
    public static OffsetContour Slot(double length, double radius) => Chain(true, (0, -radius, 0), (length, -radius, 1), (length, radius, 0), (0, radius, 1));

    public static OffsetContour RoundedRectangle(double width, double height, double radius)
    {
        var quarter = Math.Tan(Math.PI / 8.0);
        return Chain(true, (radius, 0, 0), (width - radius, 0, quarter), (width, radius, 0), (width, height - radius, quarter), (width - radius, height, 0), (radius, height, quarter), (0, height - radius, 0), (0, radius, quarter));
    }

    /// <summary>Corners alternately on two circles, the first on the outer one at angle 0.</summary>
    public static OffsetContour Star(int points, double outer, double inner) => Polygon([.. Enumerable.Range(0, 2 * points).Select(i =>
    {
        var (radius, angle) = (i % 2 == 0 ? outer : inner, Math.PI * i / points);
        return (radius * Math.Cos(angle), radius * Math.Sin(angle));
    })]);

    /// <summary>Teeth and gaps of equal angle: arcs on the root and tip circles, radial flanks.</summary>
    public static OffsetContour Gear(int teeth, double root, double tip)
    {
        var step = Math.PI / teeth;
        var bulge = Math.Tan(step / 4.0);
        return Chain(true, [.. Enumerable.Range(0, teeth).SelectMany(tooth =>
        {
            var (a, b) = (2.0 * tooth * step, ((2.0 * tooth) + 1.0) * step);
            return new (double, double, double)[]
            {
                (tip * Math.Cos(a), tip * Math.Sin(a), bulge), (tip * Math.Cos(b), tip * Math.Sin(b), 0.0),
                (root * Math.Cos(b), root * Math.Sin(b), bulge), (root * Math.Cos(b + step), root * Math.Sin(b + step), 0.0),
            };
        })]);
    }

    public static OffsetContour Reversed(OffsetContour contour) => contour with { Segments = [.. contour.Segments.Reverse().Select(segment => segment.Reversed())] };

    /// <summary>The same closed contour, starting with another segment.</summary>
    public static OffsetContour StartingAt(OffsetContour contour, int first) => contour with { Segments = [.. contour.Segments.Skip(first), .. contour.Segments.Take(first)] };
}
