using System.Text;

namespace Engraver.Core.Posts;

/// <summary>The lines of a program's text, one in memory at a time: a text of any length takes no more memory than its longest line.</summary>
/// <remarks>A line ends with LF, CR LF or CR. A line that is longer than any controller accepts is not a program line and is not stored.</remarks>
public sealed class ProgramRows(TextReader text)
{
    /// <summary>Maximum characters of a line.</summary>
    public const int Longest = 65_536;

    private readonly char[] _read = new char[4096];
    private readonly StringBuilder _line = new();
    private int _from;
    private int _to;
    private bool _isAfterReturn;

    /// <summary>Number of the line that was read last, from 1; 0 before the first.</summary>
    public int Number { get; private set; }

    /// <summary>The next line without its end; null after the last.</summary>
    /// <exception cref="InvalidDataException">The line is longer than <see cref="Longest"/>.</exception>
    /// <exception cref="IOException">Reading the text fails.</exception>
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

    /// <summary>True when there is a further character; the LF of a CR LF does not count.</summary>
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
