using System.Text;

namespace Engraver.Core.TextMarkup;

/// <summary>Reads the string of a TEXT, ATTRIB or ATTDEF (group 1) into characters and their marks. DXF reference, "TEXT".</summary>
public sealed class TextCodes
{
    private readonly string _raw;
    private readonly Dictionary<int, int> _fieldEnds;
    private readonly List<TextRun> _runs = [];
    private readonly CodeList _unknown = new();
    private readonly StringBuilder _run = new();
    private LineMarks _runMarks;
    private LineMarks _marks;

    private TextCodes(string raw) => (_raw, _fieldEnds) = (raw, FieldCodes.EndsIn(raw));

    /// <summary>Reads any string, in a time proportional to its length. %% before anything that is not a code are two characters.</summary>
    /// <param name="raw">As written: %% codes, \U+XXXX and \M+nXXXX, control characters with a caret.</param>
    public static TextLine Parse(string raw)
    {
        ArgumentNullException.ThrowIfNull(raw);
        return new TextCodes(raw).Read();
    }

    private TextLine Read()
    {
        for (var at = 0; at < _raw.Length;) at = Next(at);
        EndRun();
        return new TextLine(_runs, _unknown.Codes);
    }

    /// <summary>Takes what begins at an index; returns the index after it.</summary>
    private int Next(int at)
    {
        if (_fieldEnds.TryGetValue(at, out var end))
        {
            _unknown.Add(_raw.AsSpan(at, end - at)); // a field that was not evaluated: the file has no value for it
            return end;
        }

        if (_raw[at] == '\\' && CharacterEscapes.LengthAt(_raw, at, out var meant) is > 0 and var escape)
        {
            Append(meant);
            return at + escape;
        }

        if (SpecialCharacters.PercentLength(_raw, at, out var character, out var switched, out _) is > 0 and var length)
        {
            _marks ^= switched;
            if (character.Length > 0) Append(character);
            else if (switched == LineMarks.None) _unknown.Add(_raw.AsSpan(at, length));
            return at + length;
        }

        if (SpecialCharacters.IsCaretCode(_raw, at, out var control))
        {
            Character(control, at, 2);
            return at + 2;
        }

        if (at + 2 < _raw.Length && _raw[at] == '%' && _raw[at + 1] == '%')
        {
            _unknown.Add(_raw.AsSpan(at, 3));
            Append("%%");
            return at + 2;
        }

        Character(_raw[at], at, 1);
        return at + 1;
    }

    private void Character(char one, int at, int length)
    {
        if (one == '\n') Append(" "); // a text has one line
        else if (one is '\t' or >= ' ') Append(one.ToString());
        else if (one != '\r') _unknown.Add(_raw.AsSpan(at, length));
    }

    private void Append(string characters)
    {
        if (_run.Length > 0 && _runMarks != _marks) EndRun();
        _runMarks = _marks;
        _run.Append(characters);
    }

    private void EndRun()
    {
        if (_run.Length == 0) return;
        _runs.Add(new TextRun(_run.ToString(), _runMarks));
        _run.Clear();
    }
}
