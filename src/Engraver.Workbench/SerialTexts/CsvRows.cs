using System.Globalization;

namespace Engraver.Workbench.SerialTexts;

/// <summary>Reads which rows of a CSV file are engraved: <c>3-7</c>, <c>3-</c>, <c>1,4,6-9</c>.</summary>
public static class CsvRows
{
    /// <returns>The numbers in the order of the text; null if it is not such a text, or a row does not exist.</returns>
    public static IReadOnlyList<int>? Read(string text, int count)
    {
        ArgumentNullException.ThrowIfNull(text);
        var rows = new List<int>();
        foreach (var part in text.Split(','))
        {
            var dash = part.IndexOf('-', StringComparison.Ordinal);
            if (Number(dash < 0 ? part : part[..dash]) is not { } first) return null;
            var last = dash < 0 ? first : part[(dash + 1)..].Length == 0 ? count : Number(part[(dash + 1)..]);
            if (last is not { } end || first < 1 || end < first || end > count) return null;
            rows.AddRange(Enumerable.Range(first, end - first + 1));
        }

        return rows.Count <= count && rows.Distinct().Count() == rows.Count ? rows : null;
    }

    private static int? Number(string text) => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var number) ? number : null;
}
