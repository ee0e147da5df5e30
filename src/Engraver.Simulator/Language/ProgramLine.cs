using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>One line of program memory: the text as downloaded, its label if any, and the statements after the label.</summary>
internal sealed record ProgramLine(string Text, string? Label, Statement[] Parts)
{
    private const int LongestLabel = 7;

    /// <summary>Parses a line; a bad label is refused with TC 61. Characters other than letters and digits are tolerated ("_" occurs in the field, E
    /// Label).</summary>
    public static ProgramLine Parse(string text)
    {
        var parts = Statements.Split(text);
        if (parts[0].Text is not ['#', ..]) return new(text, null, parts);

        var label = parts[0].Text[1..];
        var good = label.Length is > 0 and <= LongestLabel
            && !char.IsAsciiDigit(label[0])
            && label.All(c => char.IsAsciiLetterOrDigit(c) || c == '_');
        return good ? new(text, label, parts[1..]) : throw new CommandRefusedException(Tc.BadLabel);
    }
}
