using System.Globalization;
using System.Text;

namespace Engraver.Core.Posts.HpglReading;

/// <summary>A command of HP-GL/2: two letters and its numbers (rs274-hpgl.md 3.1).</summary>
/// <param name="Name">Name in capitals.</param>
/// <param name="Line">Line of the text, from 1.</param>
internal sealed record HpglCommand(string Name, IReadOnlyList<double> Values, int Line);

/// <summary>Reads commands from a text, one by one. A command ends at a semicolon or where the next letters begin; blanks and line ends between commands mean
/// nothing.</summary>
/// <remarks>A command with very many numbers is returned in parts with the same name: moving through a list of points equals moving through its parts, and no
/// other command has so many numbers.</remarks>
internal sealed class HpglScanner(TextReader text)
{
    /// <summary>Numbers of a part, in whole pairs.</summary>
    private const int MaxValues = 1024;

    /// <summary>Maximum characters of a number; a longer text is not a number.</summary>
    private const int LongestNumber = 64;

    private readonly char[] _name = new char[2];
    private readonly StringBuilder _word = new();
    private bool _isInList;
    private bool _isValueExpected;

    public int Line { get; private set; } = 1;

    /// <summary>The next command, or the next part of a long one; null at the end, and for an invalid command, with the reason.</summary>
    public HpglCommand? Next(out string reason)
    {
        reason = "";
        if (!_isInList)
        {
            while (text.Peek() is >= 0 and var sign && (char.IsWhiteSpace((char)sign) || sign == ';')) Step();
            if (text.Peek() < 0) return null;
            if (!IsNamed(out var read))
            {
                reason = Wording.Get("HpglReader.UnknownCommand", read);
                return null;
            }
        }

        var (name, line) = (new string(_name), Line);
        if (Numbers(out var wrong) is { } values) return new HpglCommand(name, values, line);
        reason = Wording.Get("HpglReader.NumbersExpected", name, wrong);
        return null;
    }

    private bool IsNamed(out string read)
    {
        _word.Clear();
        while (_word.Length < _name.Length && text.Peek() is >= 0 and var sign && char.IsAsciiLetter((char)sign)) _word.Append(Step());
        for (var i = 0; i < _word.Length; i++) _name[i] = char.ToUpperInvariant(_word[i]);
        var isName = _word.Length == _name.Length;
        if (!isName && text.Peek() >= 0) _word.Append(Step());
        read = _word.ToString();
        return isName;
    }

    private char Step()
    {
        var sign = (char)text.Read();
        if (sign == '\n') Line++;
        return sign;
    }

    /// <summary>Numbers separated by a comma or blanks; no numbers give an empty list. Null for an invalid list of numbers.</summary>
    private List<double>? Numbers(out string wrong)
    {
        var values = new List<double>();
        wrong = ",";
        while (true)
        {
            while (text.Peek() is >= 0 and var blank && char.IsWhiteSpace((char)blank)) Step();
            if (text.Peek() is < 0 or ';' || char.IsAsciiLetter((char)text.Peek())) return EndOf(values);
            if (text.Peek() == ',')
            {
                if (_isValueExpected || !_isInList) return null;
                _isValueExpected = true;
                Step();
                continue;
            }

            if (values.Count == MaxValues) return values;
            if (Number(out wrong) is not { } value) return null;
            values.Add(value);
            (_isInList, _isValueExpected, wrong) = (true, false, ",");
        }
    }

    private List<double>? EndOf(List<double> values)
    {
        _isInList = false;
        return _isValueExpected ? null : values;
    }

    private double? Number(out string word)
    {
        _word.Clear();
        while (text.Peek() is >= 0 and not (',' or ';') and var sign && !char.IsWhiteSpace((char)sign) && !char.IsAsciiLetter((char)sign) && _word.Length <= LongestNumber) _word.Append(Step());
        word = _word.ToString();
        return _word.Length <= LongestNumber && double.TryParse(word, NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var value) && Math.Abs(value) <= 8_388_608.0 ? value : null;
    }
}
