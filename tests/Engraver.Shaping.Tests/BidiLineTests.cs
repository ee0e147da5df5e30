using System.Globalization;

namespace Engraver.Shaping.Tests;

/// <summary>The order of a line, compared with the cases of BidiTest.txt of the Unicode Character Database where that file is installed.</summary>
public class BidiLineTests
{
    public const string ConformanceFile = "/usr/share/unicode/BidiTest.txt";

    private const int FromText = 1;
    private const int LeftToRight = 2;
    private const int RightToLeft = 4;

    /// <summary>A character of each class; the classes of marks of direction and of ends of lines are left out.</summary>
    private static readonly Dictionary<string, char> s_characters = new()
    {
        ["L"] = 'a', ["R"] = '\u05D0', ["AL"] = '\u0628', ["EN"] = '1', ["ES"] = '+', ["ET"] = '%', ["AN"] = '\u0661', ["CS"] = ',', ["NSM"] = '\u0301', ["WS"] = ' ', ["ON"] = '!',
    };

    [ConformanceFact]
    public void Lines_without_marks_of_direction_are_ordered_as_Unicode_requires()
    {
        const string Reorder = "@Reorder:";
        var (order, count, different) = ("", 0, new List<string>());
        foreach (var line in File.ReadLines(ConformanceFile))
        {
            if (line.StartsWith(Reorder, StringComparison.Ordinal)) order = line[Reorder.Length..].Trim();
            if (line.Length == 0 || line[0] is '#' or '@' || line.Split(';') is not [var classes, var directions]) continue;
            var names = classes.Split(' ');
            if (!names.All(s_characters.ContainsKey)) continue;
            var (text, asked) = (string.Concat(names.Select(name => s_characters[name])), int.Parse(directions, NumberStyles.HexNumber, CultureInfo.InvariantCulture));
            if ((asked & FromText) != 0) Check(BidiLine.PartsOf(text));
            if ((asked & LeftToRight) != 0) Check(BidiLine.PartsOf(text, isRightToLeft: false));
            if ((asked & RightToLeft) != 0) Check(BidiLine.PartsOf(text, isRightToLeft: true));

            void Check(IReadOnlyList<DirectedPart> parts)
            {
                count++;
                if (Seen(parts) is var seen && seen != order) different.Add($"{line} -> {seen}, not {order}");
            }
        }

        Assert.True(count > 10_000, $"{count} cases");
        Assert.True(different.Count == 0, $"{different.Count} of {count}: {string.Join('\n', different.Take(20))}");
    }

    private static string Seen(IReadOnlyList<DirectedPart> parts) =>
        string.Join(' ', parts.SelectMany(part => Enumerable.Range(part.Start, part.Length) is var within && part.IsRightToLeft ? within.Reverse() : within));
}
