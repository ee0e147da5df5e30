using Avalonia.Media.TextFormatting.Unicode;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>A part of a text that is shaped at once.</summary>
/// <param name="IsComplex">The part needs more than one glyph for each character.</param>
internal readonly record struct ScriptRun(int Start, int Length, bool IsComplex)
{
    private const char FirstCombiningMark = '\u0300';

    private static readonly HashSet<Script> s_simple =
    [
        Script.Unknown, Script.Latin, Script.Greek, Script.Cyrillic, Script.Armenian, Script.Georgian, Script.Han, Script.Hiragana, Script.Katakana,
        Script.KatakanaOrHiragana, Script.Bopomofo, Script.Hangul, Script.Yi, Script.Ethiopic, Script.Cherokee, Script.CanadianAboriginal, Script.Ogham,
        Script.Runic, Script.Braille,
    ];

    /// <summary>True for text from left to right in scripts that need one glyph for each character, without marks on marks.</summary>
    public static bool IsSimple(ReadOnlySpan<char> text)
    {
        if (text.IndexOfAnyInRange(FirstCombiningMark, char.MaxValue) < 0)
            return true;
        for (var index = 0; index < text.Length;)
        {
            var codepoint = Codepoint.ReadAt(text, index, out var length);
            if (!IsNeutral(codepoint) && !IsSimple(codepoint))
                return false;
            index += length;
        }
        return !HasStackedMarks(text);
    }

    /// <summary>Divides a text into parts that are simple and parts of one complex script. Spaces and punctuation belong to what is before them. Text from
    /// right to left is complex: its brackets are mirrored.</summary>
    public static List<ScriptRun> Divide(ReadOnlySpan<char> text, bool isRightToLeft)
    {
        var everyScript = isRightToLeft || HasStackedMarks(text);
        var runs = new List<ScriptRun>();
        var start = 0;
        Script? current = null;
        for (var index = 0; index < text.Length;)
        {
            var codepoint = Codepoint.ReadAt(text, index, out var length);
            if (codepoint.Value == '\t' || codepoint.IsBreakChar)
            {
                EndAt(index);
                start = index + length;
                runs.Add(new ScriptRun(index, length, false));
            }
            else if (!IsNeutral(codepoint))
            {
                var script = IsSimple(codepoint) && !everyScript ? Script.Unknown : codepoint.Script;
                if (current is not null && current != script)
                    EndAt(index);
                current = script;
            }
            index += length;
        }
        EndAt(text.Length);
        return runs;

        void EndAt(int end)
        {
            if (end > start)
                runs.Add(new ScriptRun(start, end - start, current is { } script ? script != Script.Unknown : everyScript));
            (start, current) = (end, null);
        }
    }

    private static bool IsNeutral(Codepoint codepoint) => codepoint.Script is Script.Common or Script.Inherited;

    /// <summary>Hangul is simple as syllables; its single letters are composed.</summary>
    private static bool IsSimple(Codepoint codepoint) =>
        s_simple.Contains(codepoint.Script) && codepoint.Value is not (>= 0x1100 and <= 0x11FF or >= 0xA960 and <= 0xA97F or >= 0xD7B0 and <= 0xD7FF);

    private static bool HasStackedMarks(ReadOnlySpan<char> text)
    {
        var isAfterMark = false;
        for (var index = 0; index < text.Length;)
        {
            var codepoint = Codepoint.ReadAt(text, index, out var length);
            var isMark = codepoint.GeneralCategory is GeneralCategory.NonspacingMark or GeneralCategory.EnclosingMark;
            if (isMark && isAfterMark)
                return true;
            isAfterMark = isMark;
            index += length;
        }
        return false;
    }
}
