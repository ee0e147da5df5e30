namespace Engraver.App.Canvas.Marks;

/// <summary>Digits as strokes on a grid of 4 by 6, as a plotter draws them: sharp at every size without a font.</summary>
internal static class StrokeDigits
{
    /// <summary>Height of a digit, grid units.</summary>
    public const double Height = 6.0;

    /// <summary>From one digit to the next, grid units.</summary>
    public const double Advance = 6.0;

    /// <summary>The strokes of each digit; each point is x (0 to 4) and y (0 to 6, downwards).</summary>
    private static readonly string[][] s_strokes =
    [
        ["10 30 41 45 36 16 05 01 10"],
        ["11 20 26", "16 36"],
        ["01 10 30 41 42 06 46"],
        ["01 10 30 41 42 33 44 45 36 16 05", "13 33"],
        ["36 30 04 44"],
        ["40 00 02 32 43 45 36 16 05"],
        ["31 30 20 02 05 16 36 45 44 33 13 04"],
        ["00 40 16"],
        ["10 30 41 42 33 13 02 01 10", "13 04 05 16 36 45 44 33"],
        ["05 16 26 44 41 30 10 01 02 13 33 42"],
    ];

    private static readonly Stroke[][] s_pieces = [.. s_strokes.Select(digit => digit.SelectMany(Pieces).ToArray())];

    /// <summary>The straight pieces of a digit.</summary>
    /// <param name="digit">0 to 9.</param>
    public static ReadOnlySpan<Stroke> Pieces(int digit) => s_pieces[digit];

    /// <summary>Width of a number, grid units.</summary>
    public static double WidthOf(int number) => (CountOf(number) * Advance) - (Advance - 4.0);

    /// <summary>Number of digits of a non-negative number.</summary>
    public static int CountOf(int number)
    {
        var count = 1;
        for (var rest = number / 10; rest > 0; rest /= 10) count++;
        return count;
    }

    private static IEnumerable<Stroke> Pieces(string stroke)
    {
        var places = stroke.Split(' ');
        for (var i = 1; i < places.Length; i++) yield return new Stroke(places[i - 1][0] - '0', places[i - 1][1] - '0', places[i][0] - '0', places[i][1] - '0');
    }

    /// <summary>A straight piece, grid units.</summary>
    public readonly record struct Stroke(double FromX, double FromY, double ToX, double ToY);
}
