using Engraver.Samples.Dxf;
using Engraver.Samples.Geometry;

namespace Engraver.Samples;

/// <summary>A drawing of exactly so many LINE entities: closed polygons of 10 to 50 sides on a grid, apart from each other, on three layers.</summary>
/// <remarks>The last polygon takes up the remainder, up to 59 sides; fewer than three lines make an open stroke instead.</remarks>
internal static class BenchmarkDrawing
{
    private const int FewestSides = 10;
    private const int MostSides = 50;
    private const double CellSize = 4;
    private const double LargestRadius = 0.45 * CellSize;

    private static readonly string[] Layers = ["CUT", "MARK", "DEEP"];

    /// <param name="lines">Number of LINE entities.</param>
    /// <param name="shuffled">Whether to put the lines into random order, every other one (by chance) reversed.</param>
    /// <param name="seed">The same seed gives the same drawing.</param>
    public static DxfDocument Draw(int lines, bool shuffled, ulong seed)
    {
        var random = new SeededSequence(seed);
        var drawn = Polygons(lines, random).ToArray();
        if (shuffled)
        {
            random.Shuffle<LineEntity>(drawn);
            for (var i = 0; i < drawn.Length; i++)
            {
                drawn[i] = random.Coin() ? drawn[i] with { From = drawn[i].To, To = drawn[i].From } : drawn[i];
            }
        }

        return new DxfDocument(DxfVersion.R2000, DrawingUnit.Millimetres, [.. Layers.Select((name, i) => new DxfLayer(name, i + 1))], drawn);
    }

    private static IEnumerable<LineEntity> Polygons(int lines, SeededSequence random)
    {
        var columns = (int)Math.Ceiling(Math.Sqrt(2.0 * lines / (FewestSides + MostSides)));
        var remaining = lines;
        for (var cell = 0; remaining > 0; cell++)
        {
            var sides = SidesFor(remaining, random);
            var centre = new Point((cell % columns) + 0.5, (cell / columns) + 0.5) * CellSize;
            foreach (var line in Polygon(Layers[cell % Layers.Length], centre, sides, random))
            {
                yield return line;
            }

            remaining -= sides;
        }
    }

    private static int SidesFor(int remaining, SeededSequence random)
    {
        var sides = FewestSides + random.Below(MostSides - FewestSides + 1);
        return remaining - sides < FewestSides ? remaining : sides;
    }

    /// <summary>A polygon with an uneven rim that stays within its cell.</summary>
    private static IEnumerable<LineEntity> Polygon(string layer, Point centre, int sides, SeededSequence random)
    {
        var corners = new Point[Math.Max(sides, 3)];
        for (var i = 0; i < corners.Length; i++)
        {
            corners[i] = centre + Point.Polar(LargestRadius * (0.7 + (0.3 * random.Fraction())), 360.0 * i / corners.Length);
        }

        return Enumerable.Range(0, sides).Select(i => new LineEntity(layer, corners[i], corners[(i + 1) % corners.Length]));
    }
}
