using System.Globalization;

namespace Engraver.Core.Posts.HpglReading;

/// <summary>A command of HP-GL/2: two letters and its numbers (rs274-hpgl.md 3.1).</summary>
/// <param name="Name">In capitals.</param>
/// <param name="Line">Of the text, from 1.</param>
internal sealed record HpglCommand(string Name, IReadOnlyList<double> Values, int Line);

/// <summary>Takes commands from a text, one after the other. A command ends at a semicolon or where the next letters begin; blanks and line ends between commands mean nothing.</summary>
internal sealed class HpglScanner(string text)
{
    private int _at;

    public int Line { get; private set; } = 1;

    /// <summary>The next command; null at the end, and for what is no command, with the reason.</summary>
    public HpglCommand? Next(out string reason)
    {
        reason = "";
        while (_at < text.Length && (char.IsWhiteSpace(text[_at]) || text[_at] == ';')) Step();
        if (_at >= text.Length) return null;
        var line = Line;
        if (_at + 1 >= text.Length || !char.IsAsciiLetter(text[_at]) || !char.IsAsciiLetter(text[_at + 1]))
        {
            reason = Wording.Get("HpglReader.NoCommand", Shown(text[_at..Math.Min(text.Length, _at + 8)]));
            return null;
        }

        var name = text.Substring(_at, 2).ToUpperInvariant();
        _at += 2;
        var from = _at;
        while (_at < text.Length && text[_at] != ';' && !char.IsAsciiLetter(text[_at])) Step();
        if (Numbers(text[from.._at].Trim()) is { } values) return new HpglCommand(name, values, line);
        reason = Wording.Get("HpglReader.NoNumbers", name, Shown(text[from.._at].Trim()));
        return null;
    }

    private void Step()
    {
        if (text[_at++] == '\n') Line++;
    }

    /// <summary>Apart by a comma or blanks; an empty text is none.</summary>
    private static double[]? Numbers(string words)
    {
        if (words.Length == 0) return [];
        var parts = words.Split(',').SelectMany(part => part.Trim() is { Length: > 0 } word ? word.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries) : [""]).ToList();
        var values = new double[parts.Count];
        for (var i = 0; i < values.Length; i++)
        {
            if (!double.TryParse(parts[i], NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out values[i]) || Math.Abs(values[i]) > 8_388_608.0) return null;
        }

        return values;
    }

    private static string Shown(string words) => words.Length <= 40 ? words : words[..40];
}
