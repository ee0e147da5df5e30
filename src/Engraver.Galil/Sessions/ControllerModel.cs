namespace Engraver.Galil.Sessions;

/// <summary>The model that a controller reports (^R^V): its family and the number of its axes.</summary>
/// <remarks> A model number has four digits, the third of which is the number of axes (DMC2143), or five digits, the fourth of which is it (DMC30010, DMC50040,
/// DMC52040; galil-dmc.md G). The table lists the known families; a number of the same form that is not in the table is read by the same rule. </remarks>
/// <param name="Axes">1 to 8.</param>
/// <param name="Family">As the maker calls it, for example DMC-41x3.</param>
/// <param name="IsSimulated">True for the family of the simulated controller, with which the commands were tested.</param>
internal sealed record ControllerModel(int Axes, string Family, bool IsSimulated)
{
    private const string Prefix = "DMC";

    /// <summary>The known families; x is the digit of the axes. DMC-21x2 and DMC-21x3 differ in their amplifiers.</summary>
    private static readonly (string Pattern, bool IsSimulated)[] s_families =
    [
        ("12x0", false), ("13x8", false), ("14x5", false), ("17x0", false), ("18x0", false), ("18x2", false), ("18x6", false), ("20x0", false), ("21x2", true), ("21x3", true),
        ("22x0", false), ("31x0", false), ("40x0", false), ("41x3", false), ("300x0", false), ("500x0", false), ("520x0", false),
    ];

    /// <returns>Null when the text is not a model of the DMC family.</returns>
    public static ControllerModel? Parse(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        if (!text.StartsWith(Prefix, StringComparison.Ordinal)) return null;
        var number = string.Concat(text[Prefix.Length..].TakeWhile(char.IsAsciiDigit));
        foreach (var (pattern, isSimulated) in s_families)
        {
            if (Matches(pattern, number)) return Of(number, pattern.IndexOf('x', StringComparison.Ordinal), isSimulated);
        }

        return number.Length is 4 or 5 ? Of(number, number.Length - 2, isSimulated: false) : null;
    }

    private static bool Matches(string pattern, string number) => pattern.Length == number.Length && pattern.Zip(number).All(digit => digit.First == 'x' || digit.First == digit.Second);

    private static ControllerModel? Of(string number, int place, bool isSimulated) =>
        number[place] is >= '1' and <= '8' and var axes ? new ControllerModel(axes - '0', $"{Prefix}-{number[..place]}x{number[(place + 1)..]}", isSimulated) : null;
}
