using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Chaining;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Sequencing.Ordering;

/// <summary>Random squares, circles and lines, some inside others, and their drawing in a given order of entities.</summary>
internal sealed class RandomStrokes
{
    /// <summary>Distance of the cells in which the strokes are, mm.</summary>
    private const double Cell = 30.0;

    private readonly List<Stroke> _strokes = [];

    /// <param name="count">Number of strokes.</param>
    /// <param name="levels">Number of levels of squares; 1 for nothing inside others.</param>
    public RandomStrokes(int seed, int count, int levels)
    {
        var random = new Random(seed);
        while (_strokes.Count < count)
        {
            var (x, y) = (Cell * random.Next(0, 9), Cell * _strokes.Count);
            if (random.Next(2) == 0) AddSquares(x, y, 20.0, random.Next(1, levels + 1), -1, count, random);
            else _strokes.Add(Single(x + random.Next(8), y + random.Next(8), random));
        }
    }

    public IReadOnlyList<Stroke> All => _strokes;

    public ChainedTable Chain(IReadOnlyList<int>? order = null)
    {
        var builder = new DrawingBuilder();
        foreach (var stroke in order ?? [.. Enumerable.Range(0, _strokes.Count)]) _strokes[stroke].Draw(builder);
        var drawing = builder.Build();
        return Sequencer.Chain(ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default)), drawing, UsualOptions.Sequencing);
    }

    private void AddSquares(double x, double y, double side, int levels, int around, int count, Random random)
    {
        var self = _strokes.Count;
        _strokes.Add(Stroke.Square(x, y, side, around));
        for (var inner = random.Next(1, 4); levels > 1 && inner > 0 && _strokes.Count < count; inner--)
            AddSquares(x + (0.05 * side) + (0.3 * side * inner) - (0.25 * side), y + (0.1 * side * random.Next(1, 6)), 0.2 * side, levels - 1, self, count, random);
    }

    private static Stroke Single(double x, double y, Random random) => random.Next(2) == 0
        ? Stroke.Line(x, y, x + random.Next(-7, 8) + 0.5, y + random.Next(1, 8))
        : Stroke.Circle(x, y, random.Next(1, 7));

    /// <summary>One stroke.</summary>
    /// <param name="Entries">Possible starts with the ends that belong to them.</param>
    /// <param name="Around">The stroke directly around it, -1 for none.</param>
    internal sealed record Stroke(IReadOnlyList<(Point2D Start, Point2D End)> Entries, int Around, Action<DrawingBuilder> Draw)
    {
        public static Stroke Square(double x, double y, double side, int around) =>
            new(Closed(new(x, y), new(x + side, y), new(x + side, y + side), new(x, y + side)), around, builder => builder.Square(x, y, side));

        public static Stroke Line(double x, double y, double toX, double toY)
        {
            var (from, to) = (new Point2D(x, y), new Point2D(toX, toY));
            return new Stroke([(from, to), (to, from)], -1, builder => builder.Line(x, y, toX, toY));
        }

        public static Stroke Circle(double x, double y, double radius) =>
            new(Closed(new(x + radius, y), new(x, y + radius), new(x - radius, y), new(x, y - radius)), -1, builder => builder.Circle(x, y, radius));

        private static (Point2D Start, Point2D End)[] Closed(params Point2D[] places) => [.. places.Select(place => (place, place))];
    }
}
