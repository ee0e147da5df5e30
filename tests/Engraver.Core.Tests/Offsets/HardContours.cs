using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using static Engraver.Core.Tests.Offsets.OffsetShapes;

namespace Engraver.Core.Tests.Offsets;

/// <summary>Contours that are difficult to offset: parts that collapse, touch, coincide, repeat or have an unusual size.</summary>
internal static class HardContours
{
    private static readonly (double X, double Y)[] s_crossing = [(2, 10), (-1, 7), (-1, 15), (2, 12), (-0.0627, 12.3385), (1.0, 10.9937), (0.1442, 9.4608)];

    /// <summary>Closed contours that are offset together, each at several distances.</summary>
    public static IReadOnlyList<(string Name, OffsetContour[] Contours, double[] Distances)> Closed { get; } =
    [
        ("rectangle that collapses to its middle line", [Rectangle(0, 0, 10, 4)], [1.999999, 2, 2.000001, 5]),
        ("square that collapses to its middle", [Rectangle(0, 0, 4, 4)], [1.999999999, 2, 2.000000001]),
        ("corner radius equal to the distance, and smaller", [RoundedRectangle(20, 10, 2)], [1.999999999, 2, 2.000000001, 3, 5]),
        ("slot that collapses", [Slot(10, 2)], [1.5, 2, 2.5]),
        ("circle that collapses", [Circle(3, 4, 5)], [4.999999999, 5, 5.000000001, 10]),
        ("clockwise circle", [Circle(3, 4, 5, clockwise: true)], [1, 5, 7]),
        ("circle of two half turns", [Chain(true, (-5, 0, 1), (5, 0, 1))], [1, 5, 7]),
        ("circle of two half turns, clockwise", [Chain(true, (-5, 0, -1), (5, 0, -1))], [1, 5, 7]),
        ("half disc", [Chain(true, (-5, 0, 0), (5, 0, 1))], [1, 2.4999, 2.5, 2.5001, 6]),
        ("lens", [Chain(true, (-5, 0, 0.4), (5, 0, 0.4))], [0.5, 1.9999, 2, 2.0001]),
        ("crescent", [Chain(true, (-5, 0, 1), (5, 0, -0.6))], [0.3, 0.9, 1, 1.1, 4]),
        ("three quarters of a turn", [Chain(true, (5, 0, Math.Tan(3 * Math.PI / 8)), (0, -5, 0), (0, 0, 0))], [0.5, 1.5, 2, 3]),
        ("ring that collapses", [Circle(0, 0, 7), Circle(0, 0, 5)], [0.999999999, 1, 1.000000001, 5]),
        ("ring out of centre", [Circle(0, 0, 7), Circle(1, 0, 5)], [0.4, 0.5, 0.9, 1, 1.1]),
        ("islands that touch", [Rectangle(0, 0, 20, 20), Circle(8, 10, 2), Circle(12, 10, 2)], [0.5, 1, 2, 3, 4]),
        ("island that touches the outside", [Rectangle(0, 0, 20, 20), Circle(3, 10, 3)], [0.5, 1, 3, 7]),
        ("island on the edge of the outside", [Rectangle(0, 0, 20, 20), Rectangle(0, 5, 5, 5)], [0.5, 1, 2.5, 5]),
        ("island that crosses the outside", [Rectangle(0, 0, 20, 20), Circle(0, 10, 3)], [0.5, 1, 2, 3]),
        ("coincident spans", [Rectangle(0, 0, 20, 20), Rectangle(14, 9, 2, 2)], [0.5, 2, 4]),
        ("coincident fronts", [Rectangle(0, 0, 100, 100), Rectangle(20, 20, 20, 20), Rectangle(60, 30, 20, 50)], [5, 10, 10.5, 14]),
        ("four deep", [Rectangle(0, 0, 40, 40), Rectangle(5, 5, 30, 30), Circle(20, 20, 10), Placed(Star(5, 6, 3), 1, 20)], [0.5, 1, 2.5, 4]),
        ("the same contour twice", [Rectangle(0, 0, 10, 10), Rectangle(0, 0, 10, 10)], [1, 6]),
        ("the same circle twice, once reversed", [Circle(0, 0, 5), Circle(0, 0, 5, clockwise: true)], [1, 5, 6]),
        ("squares that meet in a corner", [Rectangle(0, 0, 10, 10), Rectangle(10, 10, 10, 10)], [1, 5, 6]),
        ("squares that share a side", [Rectangle(0, 0, 10, 10), Rectangle(10, 0, 10, 10)], [1, 5, 6]),
        ("three circles that touch", [Circle(0, 0, 5), Circle(10, 0, 5), Circle(5, 5 * Math.Sqrt(3), 5)], [0.5, 0.7735, 1, 5]),
        ("pinched in a vertex", [Polygon((0, 0), (10, 0), (5, 5), (10, 10), (0, 10), (5, 5))], [0.5, 1, 3]),
        ("vertex on a side", [Polygon((0, 0), (10, 0), (10, 10), (5, 0), (0, 10))], [0.5, 1, 3]),
        ("figure of eight", [Polygon((0, 0), (10, 10), (10, 0), (0, 10))], [0.5, 1, 1.5, 3]),
        ("figure of eight of arcs", [Chain(true, (0, 0, 1), (10, 0, -1), (20, 0, -1), (10, 0, 1))], [0.5, 2, 5, 6]),
        ("pentagram", [Polygon([.. Enumerable.Range(0, 5).Select(i => (10 * Math.Cos(i * 0.8 * Math.PI), 10 * Math.Sin(i * 0.8 * Math.PI)))])], [0.3, 1, 3]),
        ("crosses itself", [Polygon(s_crossing)], [0.1, 0.25, 0.5, 1]),
        ("vertices twice", [Polygon((0, 0), (0, 0), (10, 0), (10, 0), (10, 0), (10, 10), (0, 10), (0, 10))], [1, 5, 6]),
        ("vertices on a straight side", [Polygon((0, 0), (3, 0), (5, 0), (10, 0), (10, 10), (10, 10 - 1e-7), (10, 12), (0, 12), (0, 6))], [1, 5, 6]),
        ("a spur without width", [Polygon((0, 0), (10, 0), (10, 5), (15, 5), (10, 5), (10, 10), (0, 10))], [0.5, 1, 5, 6]),
        ("a spur inwards", [Polygon((0, 0), (10, 0), (10, 5), (5, 5), (10, 5), (10, 10), (0, 10))], [0.5, 1, 2.5, 6]),
        ("there and back", [Polygon((0, 0), (10, 0))], [1, 6]),
        ("needle", [Polygon((0, 0), (100, 0), (0, 1e-3))], [1e-4, 5e-4, 1]),
        ("teeth at twice the distance", [Comb(10, 2, 5)], [0.999999, 1, 1.000001, 3]),
        ("tiny segments between long ones", [Polygon((0, 0), (10, 0), (10, 1e-7), (10 + 1e-7, 2e-7), (10, 10), (1e-7, 10), (0, 10))], [1, 5, 6]),
        ("nearly smooth corner", [Chain(true, (0, 0, 0), (10, 0, 0), (20, 1e-6, 0), (20, 10, 0), (10, 10 - 1e-6, 0), (0, 10, 0))], [1, 5, 6]),
        ("arcs of nearly no sweep", [Chain(true, (0, 0, 1e-5), (10, 0, -1e-5), (10, 10, 2e-5), (0, 10, -2e-5))], [1, 4.9, 6]),
        ("keyhole", [Chain(true, (-1, 0, 0), (-1, -10, 0), (1, -10, 0), (1, 0, Math.Tan(Math.PI * 0.45)))], [0.5, 0.999999, 1, 1.2, 4]),
        ("gear", [Gear(12, 8, 10)], [0.2, 0.9, 1, 1.1, 3]),
        ("far from everything it is offset by", [Star(5, 10, 4)], [1e-6, 1e3, 1e4]),
    ];

    /// <summary>Open contours, each at several distances.</summary>
    public static IReadOnlyList<(string Name, OffsetContour Contour, double[] Distances)> Open { get; } =
    [
        ("ends that come back to each other", Line((0, 0), (10, 0), (10, 10), (0, 10), (0, 0.5)), [0.2, 0.25, 0.3, 1, 6]),
        ("open, but its ends meet", Line((0, 0), (10, 0), (10, 10), (0, 10), (0, 0)), [1, 5, 6]),
        ("end inside the offset of another part", Line((0, 0), (20, 0), (20, 10), (10, 10), (10, 0.7)), [0.5, 0.7, 1, 2]),
        ("end on another part", Line((0, 0), (20, 0), (20, 10), (10, 10), (10, 0)), [0.5, 1, 2]),
        ("nearly a whole turn", Chain(false, (5, 0, Math.Tan(359 * Math.PI / 720)), (5 * Math.Cos(Math.PI / 180), -5 * Math.Sin(Math.PI / 180), 0)), [0.04, 1, 5, 6]),
        ("crosses itself", Line((0, 0), (10, 10), (10, 0), (0, 10), (5, 12)), [0.5, 1, 3]),
        ("there and half back", Line((0, 0), (10, 0), (5, 0)), [1, 6]),
        ("sharp zigzag", Line((0, 0), (10, 0.5), (0, 1), (10, 1.5), (0, 2)), [0.1, 0.2, 0.25, 0.3, 2]),
        ("one line", Line((0, 0), (10, 0)), [1, 20]),
        ("half turns in turn", Chain(false, (0, 0, 1), (4, 0, -1), (8, 0, 1), (12, 0, 0)), [0.5, 2, 3]),
        ("steps of 0.0125", Line([.. Enumerable.Range(0, 60).Select(i => (0.0125 * ((i + 1) / 2), 0.0125 * (i / 2)))]), [2e-5, 0.006, 0.01, 1]),
        ("repeated points", Line((0, 0), (0, 0), (5, 0), (5, 0), (5, 5)), [1, 6]),
    ];

    /// <summary>The same contour in another size and position.</summary>
    public static OffsetContour Placed(OffsetContour contour, double scale, double at)
    {
        return contour with { Segments = [.. contour.Segments.Select(Map)] };
        Point2D Place(Point2D place) => new((place.X * scale) + at, (place.Y * scale) + at);
        Segment Map(Segment segment) => segment.Kind == SegmentKind.Line
            ? Segment.FromLine(Place(segment.Start), Place(segment.End))
            : Segment.FromArc(segment.Arc with { Centre = Place(segment.Arc.Centre), Radius = segment.Arc.Radius * scale }, Place(segment.Start), Place(segment.End));
    }

    /// <summary>Upright teeth on a bar; the gaps are as wide as the teeth.</summary>
    private static OffsetContour Comb(int teeth, double width, double height) => Polygon([(0, -5), ((2 * teeth * width) - width, -5), .. Enumerable.Range(0, teeth).Reverse().SelectMany(i =>
        new[] { (((2 * i) + 1) * width, 0.0), (((2 * i) + 1) * width, height), (2 * i * width, height), (2 * i * width, 0.0) })]);
}
