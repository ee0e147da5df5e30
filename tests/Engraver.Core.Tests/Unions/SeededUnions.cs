using Engraver.Core.Geometry;
using static Engraver.Core.Tests.Offsets.OffsetShapes;

namespace Engraver.Core.Tests.Unions;

/// <summary>Contours to unite, by number: on a lattice, where edges coincide, arcs touch and many edges meet in a point; and anywhere.</summary>
internal static class SeededUnions
{
    private static readonly double[] s_bulges = [0.0, 0.0, 0.0, 1.0, -1.0, Math.Tan(Math.PI / 8.0), -Math.Tan(Math.PI / 8.0), 0.3];

    public static IReadOnlyList<IReadOnlyList<Segment>> Of(int seed)
    {
        var random = new Random(seed);
        IReadOnlyList<IReadOnlyList<Segment>> contours = (seed % 5) switch
        {
            0 => Contours(random, 1 + random.Next(6), () => Lattice(random, 3 + random.Next(6), random.Next(2) == 0 ? 3 : 6)),
            1 => Contours(random, 1 + random.Next(5), () => Anywhere(random, 3 + random.Next(8), arcs: true)),
            2 => Contours(random, 2 + random.Next(12), () => Tile(random)),
            3 => Contours(random, 1 + random.Next(6), () => Ring(random)),
            _ => Contours(random, 1 + random.Next(3), () => Anywhere(random, 3 + random.Next(20), arcs: random.Next(2) == 0)),
        };
        return random.Next(3) == 0 ? Mapped(contours, Transform2D.Rotate(new Point2D(1.0, 2.0), Angle.FromDegrees(360.0 * random.NextDouble()))) : contours;
    }

    /// <summary>Copies that are moved and turned by less and by more than the tolerance.</summary>
    public static IReadOnlyList<IReadOnlyList<Segment>> AlmostEqual(int seed)
    {
        var random = new Random(seed);
        var contour = random.Next(2) == 0 ? Lattice(random, 3 + random.Next(6), 4) : Anywhere(random, 3 + random.Next(5), arcs: true);
        var contours = new List<IReadOnlyList<Segment>> { contour };
        for (var copies = 1 + random.Next(3); copies > 0; copies--)
        {
            var (by, turn) = (Math.Pow(10.0, -random.Next(5, 13)), Math.Pow(10.0, -random.Next(5, 13)));
            contours.AddRange(Mapped([contour], new Transform2D(1.0, Angle.FromRadians(turn), false, new Vector2D(by * random.NextDouble(), by * random.NextDouble()))));
        }

        return contours;
    }

    public static IReadOnlyList<IReadOnlyList<Segment>> Mapped(IReadOnlyList<IReadOnlyList<Segment>> contours, Transform2D map) =>
        [.. contours.Select(contour => Closed([.. contour.Select(segment => segment.Mapped(map))]))];

    public static IReadOnlyList<Segment> Reversed(IReadOnlyList<Segment> contour) => [.. contour.Reverse().Select(segment => segment.Reversed())];

    private static IReadOnlyList<Segment> Closed(Segment[] contour) =>
        [.. contour.Select((segment, i) => segment.Kind == SegmentKind.Arc ? Segment.FromArc(segment.Arc, contour[i].Start, contour[(i + 1) % contour.Length].Start) : segment)];

    private static IReadOnlyList<Segment>[] Contours(Random random, int count, Func<IReadOnlyList<Segment>> create)
    {
        var contours = new List<IReadOnlyList<Segment>>();
        while (contours.Count < count)
        {
            var contour = create();
            contours.Add(random.Next(3) == 0 ? Reversed(contour) : contour);
            if (random.Next(8) == 0) contours.Add(random.Next(2) == 0 ? contour : Reversed(contour));
        }

        return [.. contours];
    }

    private static IReadOnlyList<Segment> Lattice(Random random, int count, int size)
    {
        var vertices = new List<(double X, double Y, double Bulge)>();
        while (vertices.Count < count)
        {
            var (x, y) = (random.Next(size), random.Next(size));
            if (vertices.Count > 0 && vertices[^1].X == x && vertices[^1].Y == y) continue;
            if (vertices.Count == count - 1 && vertices[0].X == x && vertices[0].Y == y) continue;
            vertices.Add((x, y, s_bulges[random.Next(s_bulges.Length)]));
        }

        return Chain(true, [.. vertices]).Segments;
    }

    private static IReadOnlyList<Segment> Anywhere(Random random, int count, bool arcs)
    {
        var (x, y, size) = (10.0 * random.NextDouble(), 10.0 * random.NextDouble(), 1.0 + (9.0 * random.NextDouble()));
        return Chain(true, [.. Enumerable.Range(0, count).Select(_ => (x + (size * random.NextDouble()), y + (size * random.NextDouble()), arcs && random.Next(2) == 0 ? (2.0 * random.NextDouble()) - 1.0 : 0.0))]).Segments;
    }

    private static IReadOnlyList<Segment> Tile(Random random) => random.Next(4) == 0
        ? Circle(random.Next(4), random.Next(4), 0.5 * (1 + random.Next(3))).Segments
        : Rectangle(random.Next(4), random.Next(4), 1 + random.Next(2), 1 + random.Next(2)).Segments;

    private static IReadOnlyList<Segment> Ring(Random random)
    {
        var (x, y, radius) = (random.Next(3) * 1.5, random.Next(2) * 1.5, 0.75 * (1 + random.Next(3)));
        return random.Next(3) == 0 ? Star(3 + random.Next(5), radius, radius / 2.0).Segments : Circle(x, y, radius, clockwise: random.Next(2) == 0).Segments;
    }
}
