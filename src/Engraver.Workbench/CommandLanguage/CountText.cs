using System.Globalization;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>A number with its noun: <c>1 error</c>, <c>2 errors</c>, <c>0 entities</c>.</summary>
public static class CountText
{
    /// <param name="noun">In the singular; the plural is regular English.</param>
    public static string Format(int count, string noun) => $"{count.ToString(CultureInfo.InvariantCulture)} {(count == 1 ? noun : Plural(noun))}";

    private static string Plural(string noun) => noun.EndsWith('y') ? noun[..^1] + "ies" : noun + "s";
}
