using Engraver.Benchmarks.Stages;
using Engraver.Core.Geometry;

namespace Engraver.Benchmarks.Ordering;

/// <summary>The kinds of instances. The area grows with the number of strokes: about one stroke for each 100 mm2.</summary>
internal static class OrderInstances
{
    private const double Pitch = 10.0;

    /// <summary>Distance of the seeds of one letter from those of another.</summary>
    private const ulong OtherSeeds = 1_000_003;

    public static IReadOnlyList<string> Names { get; } =
    [
        "random-20", "random-200", "clustered-200", "nested-200", "plates-200", "open-200", "text-200", "random-500", "nested-500", "random-2000", "clustered-2000",
        "nested-2000", "plates-2000", "open-2000", "text-2000", "random-10000", "nested-10000", "random-50000",
        "plates-200b", "random-500b", "clustered-500b", "nested-500b", "random-2000b", "nested-2000b",
    ];

    /// <param name="name">Kind and number of strokes, and a letter for other seeds: those with a <c>b</c> are not used to choose settings.</param>
    public static OrderInstance Make(string name)
    {
        var at = name.IndexOf('-', StringComparison.Ordinal);
        var (number, seeds) = char.IsLetter(name[^1]) ? (name[(at + 1)..^1], OtherSeeds * name[^1]) : (name[(at + 1)..], 0UL);
        var count = int.Parse(number, System.Globalization.CultureInfo.InvariantCulture);
        var random = new SeededSequence((ulong)count + 7 + seeds);
        return new OrderInstance(name, name[..at] switch
        {
            "random" => Spread(count, random, (x, y) => Part(new Point2D(x, y), random)),
            "clustered" => Clustered(count, random),
            "nested" => Nested(count, random),
            "plates" => Plates(count, random),
            "open" => Spread(count, random, (x, y) => Stroke(new Point2D(x, y), random)),
            "text" => Text(count, random),
            _ => throw new ArgumentException("unknown kind of instance", nameof(name)),
        });
    }

    private static List<OrderShape> Spread(int count, SeededSequence random, Func<double, double, OrderShape> make)
    {
        var (columns, shapes) = ((int)Math.Ceiling(Math.Sqrt(2.0 * count)), new List<OrderShape>());
        int[] cells = [.. Enumerable.Range(0, columns * columns)];
        random.Shuffle<int>(cells);
        for (var i = 0; i < count; i++) shapes.Add(make((cells[i] % columns * Pitch) + (4.0 * random.Fraction()), (cells[i] / columns * Pitch) + (4.0 * random.Fraction())));
        return shapes;
    }

    /// <summary>A circle, a polygon or an open stroke of a few millimetres.</summary>
    private static OrderShape Part(Point2D place, SeededSequence random) => random.Below(3) switch
    {
        0 => OrderShape.Circle(place, 0.5 + (2.0 * random.Fraction()), -1),
        1 => OrderShape.Polygon(place, 1.0 + (1.8 * random.Fraction()), 3 + random.Below(6), random.Fraction(), -1),
        _ => Stroke(place, random),
    };

    private static OrderShape Stroke(Point2D place, SeededSequence random)
    {
        var angle = Math.Tau * random.Fraction();
        return OrderShape.Path([place, OrderShape.OnCircle(place, 1.0 + (4.0 * random.Fraction()), angle), OrderShape.OnCircle(place, 1.0 + (4.0 * random.Fraction()), angle + 0.8)]);
    }

    private static List<OrderShape> Clustered(int count, SeededSequence random)
    {
        var size = Math.Sqrt(count) * Pitch;
        Point2D[] centres = [.. Enumerable.Range(0, Math.Max(3, count / 50)).Select(_ => new Point2D(size * random.Fraction(), size * random.Fraction()))];
        var shapes = new List<OrderShape>();
        for (var i = 0; i < count; i++)
        {
            var place = OrderShape.OnCircle(centres[random.Below(centres.Length)], 0.08 * size * Math.Sqrt(-Math.Log(1.0 - random.Fraction())), Math.Tau * random.Fraction());
            shapes.Add(random.Coin() ? OrderShape.Polygon(place, 0.1 + (0.3 * random.Fraction()), 3 + random.Below(4), random.Fraction(), -1) : Hook(place, random));
        }

        return shapes;
    }

    private static OrderShape Hook(Point2D place, SeededSequence random) =>
        OrderShape.Path([place, OrderShape.OnCircle(place, 0.5, Math.Tau * random.Fraction()), OrderShape.OnCircle(place, 1.0, Math.Tau * random.Fraction())]);

    /// <summary>Boxes of one to four levels, several in each.</summary>
    private static List<OrderShape> Nested(int count, SeededSequence random)
    {
        var (shapes, columns) = (new List<OrderShape>(), (int)Math.Ceiling(Math.Sqrt(count / 6.0)));
        for (var cell = 0; shapes.Count < count; cell++)
        {
            var (x, y) = (cell % columns * 6.0 * Pitch, cell / columns * 6.0 * Pitch);
            AddBox(x, y, 5.0 * Pitch * (0.4 + (0.6 * random.Fraction())), 5.0 * Pitch * (0.4 + (0.6 * random.Fraction())), -1, 4, count, shapes, random);
        }

        return shapes;
    }

    private static void AddBox(double x, double y, double width, double height, int around, int levels, int count, List<OrderShape> shapes, SeededSequence random)
    {
        if (shapes.Count >= count) return;
        var self = shapes.Count;
        shapes.Add(OrderShape.Box(x, y, width, height, around));
        if (levels == 1 || Math.Min(width, height) < 1.0) return;
        var (columns, rows) = (1 + random.Below(3), 1 + random.Below(2));
        var (w, h) = (width / columns, height / rows);
        for (var cell = 0; cell < columns * rows; cell++)
        {
            if (random.Below(4) == 0) continue;
            var (left, bottom) = (x + (cell % columns * w), y + (cell / columns * h));
            AddBox(left + (0.1 * w), bottom + (0.1 * h), w * (0.3 + (0.5 * random.Fraction())), h * (0.3 + (0.5 * random.Fraction())), self, levels - 1, count, shapes, random);
        }
    }

    /// <summary>Plates with up to 40 holes and slots each.</summary>
    private static List<OrderShape> Plates(int count, SeededSequence random)
    {
        var shapes = new List<OrderShape>();
        for (var plate = 0; shapes.Count < count; plate++)
        {
            var (x, y, self) = (plate % 5 * 110.0, plate / 5 * 90.0, shapes.Count);
            shapes.Add(OrderShape.Box(x, y, 60.0 + (40.0 * random.Fraction()), 50.0 + (30.0 * random.Fraction()), -1));
            for (var hole = random.Below(40); hole >= 0 && shapes.Count < count; hole--)
            {
                var place = new Point2D(x + 5.0 + (hole % 7 * 7.5) + (2.0 * random.Fraction()), y + 5.0 + (hole / 7 * 7.0) + (2.0 * random.Fraction()));
                shapes.Add(random.Below(3) > 0 ? OrderShape.Circle(place, 0.8 + random.Fraction(), self) : OrderShape.Box(place.X - 1.0, place.Y - 1.0, 3.0, 1.5, self));
            }
        }

        return shapes;
    }

    /// <summary>Lines of letters of one to three open strokes and rings.</summary>
    private static List<OrderShape> Text(int count, SeededSequence random)
    {
        var (shapes, columns) = (new List<OrderShape>(), (int)Math.Ceiling(Math.Sqrt(count * 1.5)));
        for (var letter = 0; shapes.Count < count; letter++)
        {
            if (random.Below(6) == 0) continue;
            var (x, y) = (letter % columns * 4.0, letter / columns * -9.0);
            Point2D Grid() => new(x + (1.5 * random.Below(3)) + (0.2 * random.Fraction()), y + (3.0 * random.Below(3)) + (0.2 * random.Fraction()));
            for (var stroke = random.Below(3); stroke >= 0 && shapes.Count < count; stroke--)
            {
                var (from, to) = (Grid(), Grid());
                shapes.Add(from.IsNear(to, 0.4) ? OrderShape.Circle(from, 0.4, -1) : OrderShape.Path([from, to]));
            }
        }

        return shapes;
    }
}
