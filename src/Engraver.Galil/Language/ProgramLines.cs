namespace Engraver.Galil.Language;

/// <summary>Builds the lines of a controller program; rejects a line that is longer than the controller accepts.</summary>
internal sealed class ProgramLines
{
    private readonly List<string> _lines = [];

    public IReadOnlyList<string> Lines => _lines;

    /// <summary>Adds one line; several statements are joined by ';'. Empty statements (a wait that is not needed) are omitted.</summary>
    public ProgramLines Line(params ReadOnlySpan<string> statements)
    {
        var text = string.Join(';', statements.ToArray().Where(statement => statement.Length > 0));
        if (text.Length > DmcLimits.LineLength) throw new ArgumentException($"'{text}' is longer than {DmcLimits.LineLength} characters.", nameof(statements));
        if (text.Length > 0) _lines.Add(text);
        return this;
    }
}
