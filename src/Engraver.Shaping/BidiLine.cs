using System.Globalization;
using System.Text;

namespace Engraver.Shaping;

/// <summary>The direction of the parts of a line: rules P2, P3, W1 to W7, N1, N2, I1, I2, L1 and L2 of Unicode Standard Annex 9, for a line without marks of
/// direction. Pairs of brackets are neutral characters here (without rule N0).</summary>
internal static class BidiLine
{
    /// <summary>The parts of one direction, from left to right as they are seen. The first letter decides the direction of the line.</summary>
    public static IReadOnlyList<DirectedPart> PartsOf(string text) =>
        PartsOf(text, ClassesOf(text).FirstOrDefault(one => one is BidiClass.LeftToRight or BidiClass.RightToLeft or BidiClass.ArabicLetter) is BidiClass.RightToLeft or BidiClass.ArabicLetter);

    /// <summary>The same for a line of a direction.</summary>
    public static IReadOnlyList<DirectedPart> PartsOf(string text, bool isRightToLeft)
    {
        var classes = ClassesOf(text);
        ResolveWeak(classes, isRightToLeft);
        ResolveNeutral(classes, isRightToLeft);
        var levels = LevelsOf(classes, isRightToLeft);
        for (var i = text.Length - 1; i >= 0 && char.IsWhiteSpace(text[i]); i--) levels[i] = isRightToLeft ? 1 : 0;
        return Reordered(levels);
    }

    private static BidiClass[] ClassesOf(string text)
    {
        var classes = new BidiClass[text.Length];
        for (var i = 0; i < text.Length;)
        {
            var length = Rune.TryGetRuneAt(text, i, out var rune) ? rune.Utf16SequenceLength : 1;
            Array.Fill(classes, length == 1 && rune.Value == 0 ? BidiClass.Neutral : ClassOf(rune), i, length);
            i += length;
        }

        return classes;
    }

    private static BidiClass ClassOf(Rune rune) => rune.Value switch
    {
        (>= '0' and <= '9') or (>= 0x06F0 and <= 0x06F9) => BidiClass.EuropeanNumber,
        (>= 0x0660 and <= 0x0669) or 0x066B or 0x066C => BidiClass.ArabicNumber,
        '+' or '-' or 0x2212 => BidiClass.NumberSign,
        '#' or '%' or 0x00B0 or 0x00B1 or 0x066A or 0x2030 => BidiClass.NumberUnit,
        ',' or '.' or '/' or ':' or 0x00A0 => BidiClass.NumberSeparator,
        _ => OfCategory(rune),
    };

    private static BidiClass OfCategory(Rune rune)
    {
        var category = Rune.GetUnicodeCategory(rune);
        if (category is UnicodeCategory.NonSpacingMark or UnicodeCategory.EnclosingMark) return BidiClass.Mark;
        if (category == UnicodeCategory.CurrencySymbol) return BidiClass.NumberUnit;
        if (rune.Value is (>= 0x0600 and <= 0x07BF) or (>= 0x0860 and <= 0x08FF) or (>= 0xFB50 and <= 0xFDFF) or (>= 0xFE70 and <= 0xFEFE)) return Rune.IsLetter(rune) ? BidiClass.ArabicLetter : BidiClass.Neutral;
        if (rune.Value is (>= 0x0590 and <= 0x05FF) or (>= 0x07C0 and <= 0x085F) or (>= 0xFB1D and <= 0xFB4F) or (>= 0x10800 and <= 0x10FFF) or (>= 0x1E800 and <= 0x1EFFF)) return BidiClass.RightToLeft;
        return Rune.IsLetter(rune) || category is UnicodeCategory.SpacingCombiningMark or UnicodeCategory.LetterNumber ? BidiClass.LeftToRight : BidiClass.Neutral;
    }

    /// <summary>Numbers, and what is beside them: W1 to W7.</summary>
    private static void ResolveWeak(BidiClass[] classes, bool isRightToLeft)
    {
        var start = isRightToLeft ? BidiClass.RightToLeft : BidiClass.LeftToRight;
        var (before, strong) = (start, start);
        for (var i = 0; i < classes.Length; i++)
        {
            if (classes[i] == BidiClass.Mark) classes[i] = before;
            if (classes[i] is BidiClass.LeftToRight or BidiClass.RightToLeft or BidiClass.ArabicLetter) strong = classes[i];
            if (classes[i] == BidiClass.EuropeanNumber && strong == BidiClass.ArabicLetter) classes[i] = BidiClass.ArabicNumber;
            before = classes[i];
        }

        for (var i = 0; i < classes.Length; i++)
        {
            if (classes[i] == BidiClass.ArabicLetter) classes[i] = BidiClass.RightToLeft;
            if (i == 0 || i + 1 == classes.Length || classes[i - 1] != classes[i + 1]) continue;
            var isInNumber = (classes[i], classes[i - 1]) is (BidiClass.NumberSign, BidiClass.EuropeanNumber) or (BidiClass.NumberSeparator, BidiClass.EuropeanNumber or BidiClass.ArabicNumber);
            if (isInNumber) classes[i] = classes[i - 1];
        }

        for (var i = 0; i < classes.Length; i++)
        {
            if (classes[i] != BidiClass.NumberUnit) continue;
            var end = i;
            while (end < classes.Length && classes[end] == BidiClass.NumberUnit) end++;
            var isBesideNumber = (i > 0 && classes[i - 1] == BidiClass.EuropeanNumber) || (end < classes.Length && classes[end] == BidiClass.EuropeanNumber);
            Array.Fill(classes, isBesideNumber ? BidiClass.EuropeanNumber : BidiClass.Neutral, i, end - i);
        }

        strong = start;
        for (var i = 0; i < classes.Length; i++)
        {
            if (classes[i] is BidiClass.NumberSign or BidiClass.NumberSeparator) classes[i] = BidiClass.Neutral;
            if (classes[i] is BidiClass.LeftToRight or BidiClass.RightToLeft) strong = classes[i];
            if (classes[i] == BidiClass.EuropeanNumber && strong == BidiClass.LeftToRight) classes[i] = BidiClass.LeftToRight;
        }
    }

    /// <summary>Blanks and signs between parts of one direction take it, others that of the line: N1, N2.</summary>
    private static void ResolveNeutral(BidiClass[] classes, bool isRightToLeft)
    {
        var line = isRightToLeft ? BidiClass.RightToLeft : BidiClass.LeftToRight;
        for (var i = 0; i < classes.Length; i++)
        {
            if (classes[i] != BidiClass.Neutral) continue;
            var end = i;
            while (end < classes.Length && classes[end] == BidiClass.Neutral) end++;
            var before = i == 0 ? line : SideOf(classes[i - 1]);
            var after = end == classes.Length ? line : SideOf(classes[end]);
            Array.Fill(classes, before == after ? before : line, i, end - i);
        }

        static BidiClass SideOf(BidiClass one) => one == BidiClass.LeftToRight ? BidiClass.LeftToRight : BidiClass.RightToLeft;
    }

    private static int[] LevelsOf(BidiClass[] classes, bool isRightToLeft) =>
        [.. classes.Select(one => (one, isRightToLeft) switch { (BidiClass.LeftToRight, false) => 0, (BidiClass.RightToLeft, _) => 1, _ => 2 })];

    /// <summary>Reverses from the highest level down to the lowest odd one: L2.</summary>
    private static List<DirectedPart> Reordered(int[] levels)
    {
        var parts = new List<(int Start, int Length, int Level)>();
        for (var i = 0; i < levels.Length; i++)
        {
            if (parts.Count > 0 && parts[^1].Level == levels[i]) parts[^1] = parts[^1] with { Length = parts[^1].Length + 1 };
            else parts.Add((i, 1, levels[i]));
        }

        for (var level = parts.Count == 0 ? 0 : parts.Max(part => part.Level); level > 0; level--)
        {
            for (var i = 0; i < parts.Count; i++)
            {
                var end = i;
                while (end < parts.Count && parts[end].Level >= level) end++;
                if (end - i > 1) parts.Reverse(i, end - i);
                i = Math.Max(i, end);
            }
        }

        return [.. parts.Select(part => new DirectedPart(part.Start, part.Length, (part.Level & 1) != 0))];
    }
}
