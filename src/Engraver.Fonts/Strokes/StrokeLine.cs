using System.Globalization;

namespace Engraver.Fonts.Strokes;

/// <summary>A line of a file of a stroke font, for its numbers, its characters and its faults.</summary>
internal sealed record StrokeLine(string File, int Number, string Text)
{
    /// <summary>The lines that are not empty and not a comment.</summary>
    public static IEnumerable<StrokeLine> In(string file, TextReader reader)
    {
        for (var number = 1; reader.ReadLine() is { } text; number++)
        {
            if (text.Trim().Length > 0 && text[0] != '#') yield return new StrokeLine(file, number, text);
        }
    }

    public static string[] Words(string text) => text.Split(' ', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);

    public StrokeFontException Fault(StrokeFault fault, string found) => new(fault, File, Number, found);

    public double NumberOf(string word) =>
        double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out var number) && Math.Abs(number) <= 100_000 ? number : throw Fault(StrokeFault.NotANumber, word);

    /// <returns>The code point of a word that is one character, or U+ and hexadecimal digits.</returns>
    public int CharacterOf(string word)
    {
        if (word.StartsWith("U+", StringComparison.Ordinal) && int.TryParse(word.AsSpan(2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var code) && code is >= 0 and <= 0x10FFFF) return code;
        var runes = word.EnumerateRunes();
        return runes.MoveNext() && runes.Current is var rune && !runes.MoveNext() ? rune.Value : throw Fault(StrokeFault.NotACharacter, word);
    }
}
