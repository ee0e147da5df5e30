using System.Text;

namespace Engraver.Core.Posts;

/// <summary>The lines of a program's text, one held at a time: a text of any length takes no more memory than its longest line.</summary>
/// <remarks>A line ends with LF, CR LF or CR. One that is longer than any controller takes is no line of a program, and is not gathered.</remarks>
public sealed class ProgramRows(TextReader text)
{
    /// <summary>Characters of a line.</summary>
    public const int Longest = 65_536;

    private readonly char[] _read = new char[4096];
    private readonly StringBuilder _line = new();
    private int _from;
    private int _to;
    private bool _isAfterReturn;

    /// <summary>Of the line that was taken last, from 1; 0 before the first.</summary>
    public int Number { get; private set; }

    /// <summary>The next line without its end; null behind the last.</summary>
    /// <exception cref="InvalidDataException">The line is longer than <see cref="Longest"/>.</exception>
    /// <exception cref="IOException">The text cannot be read on.</exception>
    public string? Next()
    {
        _line.Clear();
        while (Fill())
        {
            var rest = _read.AsSpan(_from, _to - _from);
            var end = rest.IndexOfAny('\r', '\n');
            Keep(end < 0 ? rest : rest[..end]);
            _from += end < 0 ? rest.Length : end + 1;
            if (end < 0) continue;
            _isAfterReturn = rest[end] == '\r';
            Number++;
            return _line.ToString();
        }

        if (_line.Length == 0) return null;
        Number++;
        return _line.ToString();
    }

    /// <summary>Whether there is a character left; the LF of a CR LF is none.</summary>
    private bool Fill()
    {
        while (true)
        {
            if (_from == _to) (_from, _to) = (0, text.Read(_read, 0, _read.Length));
            if (_from == _to) return false;
            if (!_isAfterReturn) return true;
            _isAfterReturn = false;
            if (_read[_from] != '\n') return true;
            _from++;
        }
    }

    private void Keep(ReadOnlySpan<char> part)
    {
        if (_line.Length + part.Length > Longest) throw new InvalidDataException(Wording.Get("ProgramRows.LineTooLong", Number + 1, Longest));
        _line.Append(part);
    }
}
