namespace Engraver.Benchmarks.Stages;

/// <summary>The benchmark drawing: an exact number of lines that form separate closed polygons of 10 to 50 sides on a grid, on three layers.</summary>
/// <remarks>The last polygon takes the remainder, up to 59 sides; fewer than three lines make an open stroke instead. The generator of the samples also
/// compiles this file, so that it writes the same drawings.</remarks>
internal static class SeededPolygons
{
    private const int MinSides = 10;
    private const int MaxSides = 50;
    private const double CellSize = 4;
    private const double LargestRadius = 0.45 * CellSize;

    public static IReadOnlyList<string> Layers { get; } = ["CUT", "MARK", "DEEP"];

    /// <param name="count">Number of lines.</param>
    /// <param name="shuffled">Whether to put the lines into random order and to reverse a random half of them.</param>
    /// <param name="seed">The same seed gives the same lines.</param>
    public static SeededLine[] Lines(int count, bool shuffled, ulong seed)
    {
        var random = new SeededSequence(seed);
        var lines = new List<SeededLine>(count);
        var columns = (int)Math.Ceiling(Math.Sqrt(2.0 * count / (MinSides + MaxSides)));
        for (var cell = 0; lines.Count < count; cell++) AddPolygon(lines, cell, columns, SidesFor(count - lines.Count, random), random);
        var drawn = lines.ToArray();
        if (shuffled) Shuffle(drawn, random);
        return drawn;
    }

    private static void Shuffle(SeededLine[] lines, SeededSequence random)
    {
        random.Shuffle<SeededLine>(lines);
        for (var i = 0; i < lines.Length; i++) lines[i] = random.Coin() ? lines[i].Reversed() : lines[i];
    }

    private static int SidesFor(int remaining, SeededSequence random)
    {
        var sides = MinSides + random.Below(MaxSides - MinSides + 1);
        return remaining - sides < MinSides ? remaining : sides;
    }

    /// <summary>A polygon with an irregular outline that stays within its cell.</summary>
    private static void AddPolygon(List<SeededLine> lines, int cell, int columns, int sides, SeededSequence random)
    {
        var (x, y) = (((cell % columns) + 0.5) * CellSize, ((cell / columns) + 0.5) * CellSize);
        var corners = new (double X, double Y)[Math.Max(sides, 3)];
        for (var i = 0; i < corners.Length; i++)
        {
            var radius = LargestRadius * (0.7 + (0.3 * random.Fraction()));
            var (sine, cosine) = Math.SinCos(double.DegreesToRadians(360.0 * i / corners.Length));
            corners[i] = (x + (radius * cosine), y + (radius * sine));
        }

        for (var i = 0; i < sides; i++)
        {
            var to = corners[(i + 1) % corners.Length];
            lines.Add(new SeededLine(cell % Layers.Count, corners[i].X, corners[i].Y, to.X, to.Y));
        }
    }
}

/// <summary>A line of a benchmark drawing, drawing units.</summary>
/// <param name="Layer">Index into <see cref="SeededPolygons.Layers"/>.</param>
internal readonly record struct SeededLine(int Layer, double FromX, double FromY, double ToX, double ToY)
{
    public SeededLine Reversed() => new(Layer, ToX, ToY, FromX, FromY);
}
