namespace Engraver.Tools.CrossChecks;

/// <summary>Counts, lengths and the box of the curves, by sampling: the only formula is that of the straight line.</summary>
internal sealed class CrossCheckTally
{
    private const int Samples = 48;
    private const int Thirds = 40;
    private const int DeepestHalving = 14;
    private const double EnoughAgreement = 1e-5;

    /// <summary>Rounding error of a sum of chords, as a fraction of the distance from the origin.</summary>
    private const double Rounding = 1e-14;

    /// <summary>The two numbers of chords; neither is a multiple of the other, so that they do not miss a sharp turn by the same amount.</summary>
    private const int Coarse = 7;
    private const int Fine = 16;

    /// <summary>Ratio of the two errors: the error of a sum of chords decreases with the square of their number.</summary>
    private const double Gain = (double)(Fine * Fine) / (Coarse * Coarse);

    public Dictionary<string, int> Counts { get; } = new(StringComparer.Ordinal);

    public double Length { get; private set; }

    public (double Min, double Max) X { get; private set; } = (double.PositiveInfinity, double.NegativeInfinity);

    public (double Min, double Max) Y { get; private set; } = (double.PositiveInfinity, double.NegativeInfinity);

    public void Add(string type, IReadOnlyList<CrossCheckPiece> pieces, CrossCheckFrame frame)
    {
        Counts[type] = Counts.GetValueOrDefault(type) + 1;
        foreach (var piece in pieces)
        {
            if (piece.IsStraight) AddStraight(frame.At(piece.At(0.0)), frame.At(piece.At(1.0)));
            else AddCurve(t => frame.At(piece.At(t)));
        }
    }

    private void AddStraight(CrossCheckPoint from, CrossCheckPoint to)
    {
        Length += from.To(to);
        X = (Math.Min(X.Min, Math.Min(from.X, to.X)), Math.Max(X.Max, Math.Max(from.X, to.X)));
        Y = (Math.Min(Y.Min, Math.Min(from.Y, to.Y)), Math.Max(Y.Max, Math.Max(from.Y, to.Y)));
    }

    private void AddCurve(Func<double, CrossCheckPoint> placed)
    {
        Length += LengthOf(placed, 0.0, 1.0, DeepestHalving);
        X = Widened(X, t => placed(t).X);
        Y = Widened(Y, t => placed(t).Y);
    }

    /// <summary>Length by a coarse and a fine sum of chords, whose difference estimates the error; the piece is halved if they disagree.</summary>
    private static double LengthOf(Func<double, CrossCheckPoint> curve, double from, double to, int depth)
    {
        var (coarse, fine) = (Chords(curve, from, to, Coarse), Chords(curve, from, to, Fine));
        if (depth == 0 || Math.Abs(fine - coarse) <= (EnoughAgreement * fine) + (Rounding * curve(from).To(default))) return ((Gain * fine) - coarse) / (Gain - 1.0);
        var middle = (from + to) / 2.0;
        return LengthOf(curve, from, middle, depth - 1) + LengthOf(curve, middle, to, depth - 1);
    }

    private static double Chords(Func<double, CrossCheckPoint> curve, double from, double to, int count)
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

    /// <summary>The largest value of a function on 0 to 1: the largest sample, then a ternary search around it.</summary>
    private static double Highest(Func<double, double> value)
    {
        var (best, most) = (0, double.NegativeInfinity);
        for (var i = 0; i <= Samples; i++)
        {
            if (value((double)i / Samples) is var sample && sample > most) (best, most) = (i, sample);
        }

        var (low, high) = (Math.Max(0.0, (best - 1.0) / Samples), Math.Min(1.0, (best + 1.0) / Samples));
        for (var i = 0; i < Thirds; i++)
        {
            var (first, second) = (low + ((high - low) / 3.0), high - ((high - low) / 3.0));
            if (value(first) < value(second)) low = first;
            else high = second;
        }

        return Math.Max(most, value((low + high) / 2.0));
    }
}
