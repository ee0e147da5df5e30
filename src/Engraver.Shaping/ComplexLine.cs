using System.Globalization;
using System.Text;

namespace Engraver.Shaping;

/// <summary>A line of text in which characters are not simply side by side: letters that join, change their places or carry several marks, and text from right
/// to left.</summary>
public static class ComplexLine
{
    private const int None = 0;

    /// <summary>Blocks of scripts with rules of their own (Unicode, "Blocks"); what is between them needs none.</summary>
    private static readonly (int First, int Last)[] s_scripts =
    [
        (0x0590, 0x05FF), (0x0600, 0x06FF), (0x0700, 0x074F), (0x0750, 0x077F), (0x0780, 0x07BF), (0x07C0, 0x07FF), (0x0800, 0x085F), (0x0860, 0x08FF),
        (0x0900, 0x097F), (0x0980, 0x09FF), (0x0A00, 0x0A7F), (0x0A80, 0x0AFF), (0x0B00, 0x0B7F), (0x0B80, 0x0BFF), (0x0C00, 0x0C7F), (0x0C80, 0x0CFF),
        (0x0D00, 0x0D7F), (0x0D80, 0x0DFF), (0x0E00, 0x0E7F), (0x0E80, 0x0EFF), (0x0F00, 0x0FFF), (0x1000, 0x109F), (0x1700, 0x177F), (0x1780, 0x17FF),
        (0x1800, 0x18AF), (0x1900, 0x1CFF), (0xA840, 0xA87F), (0xA880, 0xABFF), (0xFB1D, 0xFB4F), (0xFB50, 0xFDFF), (0xFE70, 0xFEFE), (0x10800, 0x11FFF), (0x1E800, 0x1EFFF),
    ];

    /// <summary>True if the characters of the text cannot be placed side by side.</summary>
    public static bool IsComplex(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        foreach (var rune in text.EnumerateRunes())
        {
            if (IsComplex(rune)) return true;
        }

        return false;
    }

    /// <summary>True for a character of a script with rules of its own.</summary>
    public static bool IsComplex(Rune rune) => ScriptOf(rune) != None;

    /// <summary>True if a part of the text is written from right to left.</summary>
    public static bool HasRightToLeft(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        return BidiLine.PartsOf(text).Any(part => part.IsRightToLeft);
    }

    /// <summary>The order in which the parts of a line are seen from left to right: indices of the list.</summary>
    /// <param name="parts">As they are read; none is empty.</param>
    public static IReadOnlyList<int> OrderOf(IReadOnlyList<string> parts)
    {
        ArgumentNullException.ThrowIfNull(parts);
        var starts = new Dictionary<int, int>(parts.Count);
        var length = 0;
        for (var i = 0; i < parts.Count; i++)
        {
            starts[length] = i;
            length += parts[i].Length;
        }

        var order = new List<int>(parts.Count);
        foreach (var directed in BidiLine.PartsOf(string.Concat(parts)))
        {
            var first = order.Count;
            for (var at = directed.Start; at < directed.Start + directed.Length; at++)
            {
                if (starts.TryGetValue(at, out var part)) order.Add(part);
            }

            if (directed.IsRightToLeft) order.Reverse(first, order.Count - first);
        }

        return order;
    }

    /// <summary>The glyphs of a line from left to right. Clusters are indices of the text.</summary>
    public static IReadOnlyList<ShapedGlyph> Shape(string text, ShapingFace face)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(face);
        var glyphs = new List<ShapedGlyph>(text.Length);
        foreach (var part in BidiLine.PartsOf(text))
        {
            var runs = RunsOf(text, part);
            if (part.IsRightToLeft) runs.Reverse();
            foreach (var (start, length) in runs) glyphs.AddRange(face.Shape(text, start, length, part.IsRightToLeft, []));
        }

        return glyphs;
    }

    /// <summary>Divides a part by scripts; blanks, signs and marks belong to what is before them.</summary>
    private static List<(int Start, int Length)> RunsOf(string text, DirectedPart part)
    {
        var (runs, start, current) = (new List<(int Start, int Length)>(), part.Start, -1);
        for (var i = part.Start; i < part.Start + part.Length;)
        {
            var length = Rune.TryGetRuneAt(text, i, out var rune) ? rune.Utf16SequenceLength : 1;
            var script = ScriptOf(rune);
            if (script != None || Rune.IsLetter(rune))
            {
                if (current >= 0 && current != script)
                {
                    runs.Add((start, i - start));
                    start = i;
                }

                current = script;
            }

            i += length;
        }

        runs.Add((start, part.Start + part.Length - start));
        return runs;
    }

    /// <summary>Number of the script's block; 0 for scripts without rules of their own. The blocks of Arabic are one script.</summary>
    private static int ScriptOf(Rune rune)
    {
        const int Hebrew = 1, Arabic = 2, FirstOther = 3;
        if (rune.Value < s_scripts[0].First || Rune.GetUnicodeCategory(rune) == UnicodeCategory.Format) return None;
        for (var i = 0; i < s_scripts.Length; i++)
        {
            if (rune.Value < s_scripts[i].First || rune.Value > s_scripts[i].Last) continue;
            return s_scripts[i].First switch { 0x0590 or 0xFB1D => Hebrew, 0x0600 or 0x0750 or 0x0860 or 0xFB50 or 0xFE70 => Arabic, _ => FirstOther + i };
        }

        return None;
    }
}
