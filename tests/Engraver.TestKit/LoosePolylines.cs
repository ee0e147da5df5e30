using Engraver.Core.Geometry;
using FsCheck;
using FsCheck.Fluent;

namespace Engraver.TestKit;

/// <summary>Polylines of lines and arcs, each in a separate field, and the same segments as in a drawing: shuffled, each in either direction.</summary>
public sealed record LoosePolylines(IReadOnlyList<IReadOnlyList<Segment>> Polylines, Segment[] Shuffled)
{
    private const double Field = 100.0;

    public static Arbitrary<LoosePolylines> Any { get; } = Gen.Choose(0, int.MaxValue).Select(FromSeed).ToArbitrary();

    public static LoosePolylines FromSeed(int seed)
    {
        var random = new Random(seed);
        var polylines = Enumerable.Range(0, random.Next(1, 12)).Select(index => Polyline(random, index)).ToList();
        var shuffled = polylines.SelectMany(polyline => polyline).Select(segment => random.Next(2) == 0 ? segment : segment.Reversed()).ToArray();
        random.Shuffle(shuffled);
        return new LoosePolylines(polylines, shuffled);
    }

    /// <summary>Vertices are placed around the middle of the field, so that they are far apart; a third of the polylines are closed.</summary>
    private static List<Segment> Polyline(Random random, int index)
    {
        var middle = new Point2D(Field * (index % 4), Field * (index / 4));
        var vertices = random.Next(3, 20);
        var places = Enumerable.Range(0, vertices)
            .Select(i => middle + Vector2D.FromPolar(10.0 + (30.0 * random.NextDouble()), Angle.FromDegrees(360.0 * i / vertices)))
            .ToList();
        if (random.Next(3) == 0) places.Add(places[0]);
        return [.. places.Zip(places.Skip(1), (from, to) => Side(random, from, to))];
    }

    private static Segment Side(Random random, Point2D from, Point2D to)
    {
        if (random.Next(2) == 0) return Segment.FromLine(from, to);
        var bulge = (random.Next(2) == 0 ? 1.0 : -1.0) * (0.1 + random.NextDouble());
        return Segment.FromArc(ArcSegment.FromBulge(from, to, bulge), from, to);
    }
}
