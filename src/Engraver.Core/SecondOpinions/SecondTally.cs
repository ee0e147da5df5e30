namespace Engraver.Core.SecondOpinions;

/// <summary>Counts, lengths and the box of what is drawn, by sampling: no formula of any curve.</summary>
internal sealed class SecondTally
{
    private const int Samples = 48;
    private const int DeepestHalving = 14;
    private const double EnoughAgreement = 1e-5;

    public Dictionary<string, int> Counts { get; } = new(StringComparer.Ordinal);

    public double Length { get; private set; }

    public (double Min, double Max) X { get; private set; } = (double.PositiveInfinity, double.NegativeInfinity);

    public (double Min, double Max) Y { get; private set; } = (double.PositiveInfinity, double.NegativeInfinity);

    public void Add(string type, IEnumerable<Func<double, SecondPoint>> pieces, SecondFrame frame)
    {
        Counts[type] = Counts.GetValueOrDefault(type) + 1;
        foreach (var piece in pieces)
        {
            SecondPoint Placed(double t) => frame.At(piece(t));
            Length += LengthOf(Placed, 0.0, 1.0, DeepestHalving);
            X = Widened(X, t => Placed(t).X);
            Y = Widened(Y, t => Placed(t).Y);
        }
    }

    /// <summary>Chords of two finenesses; their difference says how much is missing. Halved where they disagree.</summary>
    private static double LengthOf(Func<double, SecondPoint> curve, double from, double to, int depth)
    {
        var (coarse, fine) = (Chords(curve, from, to, 8), Chords(curve, from, to, 16));
        if (depth == 0 || Math.Abs(fine - coarse) <= EnoughAgreement * fine) return ((4.0 * fine) - coarse) / 3.0;
        var middle = (from + to) / 2.0;
        return LengthOf(curve, from, middle, depth - 1) + LengthOf(curve, middle, to, depth - 1);
    }

    private static double Chords(Func<double, SecondPoint> curve, double from, double to, int count)
    {
        var (sum, last) = (0.0, curve(from));
        for (var i = 1; i <= count; i++)
        {
            var next = curve(from + ((to - from) * i / count));
            sum += last.To(next);
            last = next;
        }

        return sum;
    }

    private static (double Min, double Max) Widened((double Min, double Max) range, Func<double, double> value) =>
        (Math.Min(range.Min, -Highest(t => -value(t))), Math.Max(range.Max, Highest(value)));

    /// <summary>The largest sample, then thirds of its neighbourhood until nothing moves.</summary>
    private static double Highest(Func<double, double> value)
    {
        var best = Enumerable.Range(0, Samples + 1).MaxBy(i => value((double)i / Samples));
        var (low, high) = (Math.Max(0.0, (best - 1.0) / Samples), Math.Min(1.0, (best + 1.0) / Samples));
        for (var i = 0; i < 60; i++)
        {
            var (first, second) = (low + ((high - low) / 3.0), high - ((high - low) / 3.0));
            if (value(first) < value(second)) low = first;
            else high = second;
        }

        return Math.Max(value((double)best / Samples), value((low + high) / 2.0));
    }
}
