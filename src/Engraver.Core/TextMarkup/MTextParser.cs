using System.Globalization;
using System.Text;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.TextMarkup;

/// <summary>Reads the string of an MTEXT into paragraphs and their pieces. DXF reference, "MTEXT"; AutoCAD's help, "Format Codes for Multiline Text".</summary>
/// <remarks>A backslash begins a code, braces limit its effect, a semicolon ends its value. A code that is not known or has no valid value is reported; its
/// characters remain text, except those of a font or paragraph, which are left out. A number may come without its semicolon.</remarks>
public sealed class MTextParser
{
    private const int LastColour = 256;

    private readonly string _raw;
    private readonly int _lastSemicolon;
    private readonly Dictionary<int, int> _fieldEnds;
    private readonly List<MTextParagraph> _paragraphs = [];
    private readonly List<MTextPiece> _pieces = [];
    private readonly Stack<(MTextFormat Format, ParagraphFormat Paragraph)> _outer = [];
    private readonly CodeList _unknown = new();
    private readonly StringBuilder _run = new();
    private MTextFormat _runFormat = MTextFormat.Initial;
    private MTextFormat _format = MTextFormat.Initial;

    /// <summary>The format that the next paragraph begins with, and that of the present one.</summary>
    private ParagraphFormat _inherited = ParagraphFormat.Initial;
    private ParagraphFormat _paragraph = ParagraphFormat.Initial;
    private bool _stackMayEnd = true;

    private MTextParser(string raw)
    {
        _raw = raw;
        _lastSemicolon = raw.LastIndexOf(';');
        _fieldEnds = FieldCodes.EndsIn(raw);
    }

    /// <summary>Reads any string, in a time proportional to its length.</summary>
    /// <param name="raw">As written: groups 3 and 1 joined.</param>
    public static MTextContent Parse(string raw)
    {
        ArgumentNullException.ThrowIfNull(raw);
        return new MTextParser(raw).Read();
    }

    private MTextContent Read()
    {
        for (var at = 0; at < _raw.Length;) at = Next(at);
        for (; _outer.Count > 0; _outer.Pop()) _unknown.Add("{");
        EndParagraph();
        return new MTextContent(_paragraphs, _unknown.Codes);
    }

    /// <summary>Takes what begins at an index; returns the index after it.</summary>
    private int Next(int at)
    {
        switch (_raw[at])
        {
            case '{':
                _outer.Push((_format, _inherited));
                return at + 1;
            case '}':
                if (_outer.TryPop(out var outer)) (_format, _inherited) = outer;
                else _unknown.Add("}");
                return at + 1;
            case '\\':
                return Code(at);
            case '%':
                return Percent(at);
            case '^' when SpecialCharacters.IsCaretCode(_raw, at, out var character):
                Character(character, at, 2);
                return at + 2;
            default:
                Character(_raw[at], at, 1);
                return at + 1;
        }
    }

    private void Character(char one, int at, int length)
    {
        if (one == '\t') Add(MTextPieceKind.Tab);
        else if (one == '\n') EndParagraph();
        else if (one >= ' ') Append(one);
        else if (one != '\r') _unknown.Add(_raw.AsSpan(at, length));
    }

    private int Percent(int at)
    {
        if (_fieldEnds.TryGetValue(at, out var end))
        {
            _unknown.Add(_raw.AsSpan(at, end - at)); // a field that was not evaluated: the file has no value for it
            return end;
        }

        if (SpecialCharacters.PercentLength(_raw, at, out var character, out var switched, out _) is > 0 and var length)
        {
            if (switched != LineMarks.None) _format = _format with { Marks = _format.Marks ^ switched };
            else if (character.Length == 0) _unknown.Add(_raw.AsSpan(at, length));
            Append(character);
            return at + length;
        }

        if (at + 2 >= _raw.Length || _raw[at + 1] != '%')
        {
            Append('%');
            return at + 1;
        }

        _unknown.Add(_raw.AsSpan(at, 3));
        Append('%');
        Append('%');
        return at + 2;
    }

    private int Code(int at)
    {
        if (CharacterEscapes.LengthAt(_raw, at, out var meant) is > 0 and var escape)
        {
            Append(meant);
            return at + escape;
        }

        if (at + 1 == _raw.Length)
        {
            _unknown.Add("\\");
            Append('\\');
            return at + 1;
        }

        switch (_raw[at + 1])
        {
            case '\\' or '{' or '}':
                Append(_raw[at + 1]);
                return at + 2;
            case '~':
                Append('\u00A0');
                return at + 2;
            case 'P':
                EndParagraph();
                return at + 2;
            case 'N':
                Add(MTextPieceKind.ColumnBreak);
                return at + 2;
            case 'X':
                Add(MTextPieceKind.DimensionLineBreak);
                return at + 2;
            case 'L':
                return Mark(at, LineMarks.Underline, isOn: true);
            case 'l':
                return Mark(at, LineMarks.Underline, isOn: false);
            case 'O':
                return Mark(at, LineMarks.Overline, isOn: true);
            case 'o':
                return Mark(at, LineMarks.Overline, isOn: false);
            case 'K':
                return Mark(at, LineMarks.StrikeThrough, isOn: true);
            case 'k':
                return Mark(at, LineMarks.StrikeThrough, isOn: false);
            case 'S':
                return Stacked(at);
            case 'f' or 'F' or 'p':
                return Named(at);
            case 'A' or 'C' or 'c' or 'H' or 'Q' or 'T' or 'W':
                return Number(at);
            default:
                _unknown.Add(_raw.AsSpan(at, 2));
                Append('\\');
                return at + 1; // what follows the backslash is text
        }
    }

    private int Mark(int at, LineMarks mark, bool isOn)
    {
        _format = _format with { Marks = isOn ? _format.Marks | mark : _format.Marks & ~mark };
        return at + 2;
    }

    /// <summary>A code with a number: \H2.5; \H2x; \C1; ...</summary>
    private int Number(int at)
    {
        var start = at + 2;
        var length = MTextNumber.LengthAt(_raw.AsSpan(start));
        var end = start + length;
        var isRelative = length > 0 && _raw[at + 1] is 'H' or 'W' or 'T' && end < _raw.Length && _raw[end] is 'x' or 'X';
        if (isRelative) end++;
        if (end < _raw.Length && _raw[end] == ';' && length > 0) end++;
        if (MTextNumber.TryParse(_raw.AsSpan(start, length), out var value) && Formatted(_raw[at + 1], value, isRelative) is { } changed)
        {
            _format = changed;
            if (value < 0.0 && _raw[at + 1] is ('H' or 'W' or 'T')) _unknown.Add(_raw.AsSpan(at, end - at)); // its absolute value is used
        }
        else
        {
            _unknown.Add(_raw.AsSpan(at, end - at));
        }

        return end;
    }

    /// <summary>The present format changed by a code; null for a value that it cannot have.</summary>
    private MTextFormat? Formatted(char code, double value, bool isRelative) => code switch
    {
        'A' => value is 0.0 or 1.0 or 2.0 ? _format with { Alignment = (LineAlignment)value } : null,
        'C' => value is >= 0.0 and <= LastColour && double.IsInteger(value) ? _format with { Colour = DrawingColour.FromCode62((int)value) } : null,
        'c' => value is >= 0.0 and <= 0xFFFFFF && double.IsInteger(value) ? _format with { Colour = FromBgr((int)value) } : null,
        'Q' => _format with { Oblique = Angle.FromDegrees(value) },
        _ when value == 0.0 => null,
        'H' => Changed(_format.Height, Math.Abs(value), isRelative) is { } height ? _format with { Height = height } : null,
        'W' => Changed(_format.Width, Math.Abs(value), isRelative) is { } width ? _format with { Width = width } : null,
        _ => Finite(isRelative ? _format.Tracking * Math.Abs(value) : Math.Abs(value)) is { } tracking ? _format with { Tracking = tracking } : null,
    };

    private static MTextValue? Changed(MTextValue before, double value, bool isRelative)
    {
        if (!isRelative) return new MTextValue(value, 1.0);
        return Finite(before.Factor * value) is { } factor && double.IsFinite((before.Stated ?? 1.0) * factor) ? before with { Factor = factor } : null;
    }

    /// <summary>Null for a product that is too large or too small.</summary>
    private static double? Finite(double value) => double.IsFinite(value) && value > 0.0 ? value : null;

    private static DrawingColour FromBgr(int value) => DrawingColour.FromCode420(((value & 0xFF) << 16) | (value & 0xFF00) | ((value >> 16) & 0xFF));

    /// <summary>\f, \F and \p, which need their semicolon.</summary>
    private int Named(int at)
    {
        if (at > _lastSemicolon)
        {
            _unknown.Add(_raw.AsSpan(at, 2));
            return at + 2;
        }

        var end = _raw.IndexOf(';', at);
        var value = _raw.AsSpan((at + 2)..end);
        if (_raw[at + 1] != 'p') Font(value, at, end);
        else if (ParagraphCodes.Read(value, _inherited) is { } paragraph) _inherited = _paragraph = paragraph;
        else _unknown.Add(_raw.AsSpan(at..(end + 1)));
        return end + 1;
    }

    /// <summary>\fArial|b1|i0|c0|p34; \Ftxt,bigfont|c0;</summary>
    private void Font(ReadOnlySpan<char> value, int at, int end)
    {
        var bar = value.IndexOf('|');
        var name = CharacterEscapes.Resolved((bar < 0 ? value : value[..bar]).Trim().ToString());
        var (isBold, isItalic, set, pitch, isFamily) = (false, false, 0, 0, false);
        for (var rest = bar < 0 ? default : value[(bar + 1)..]; rest.Length > 0;)
        {
            var next = rest.IndexOf('|');
            var field = next < 0 ? rest : rest[..next];
            rest = next < 0 ? default : rest[(next + 1)..];
            if (field.IsEmpty) continue;
            var isNumber = int.TryParse(field[1..], NumberStyles.Integer, CultureInfo.InvariantCulture, out var number);
            if (isNumber && field[0] is 'b' or 'i') isFamily = true;
            if (isNumber && field[0] == 'b') isBold = number != 0;
            else if (isNumber && field[0] == 'i') isItalic = number != 0;
            else if (isNumber && field[0] == 'c') set = number;
            else if (isNumber && field[0] == 'p') pitch = number;
            else _unknown.Add(_raw.AsSpan(at..(end + 1)));
        }

        if (name.Length == 0)
        {
            _unknown.Add(_raw.AsSpan(at..(end + 1)));
            return;
        }

        var comma = name.IndexOf(',', StringComparison.Ordinal);
        var (file, big) = comma < 0 ? (name, "") : (name[..comma].Trim(), name[(comma + 1)..].Trim());
        var isShape = file.EndsWith(".shx", StringComparison.OrdinalIgnoreCase) || big.Length > 0 || (_raw[at + 1] == 'F' && !isFamily);
        _format = _format with { Font = new MTextFont(file, big, isBold, isItalic, set, pitch, isShape) };
    }

    /// <summary>\Supper^lower; with ^, / or # between; a backslash before a character makes it a character.</summary>
    private int Stacked(int at)
    {
        var (upper, lower, kind) = (new StringBuilder(), new StringBuilder(), default(MTextStackKind?));
        var place = at + 2;
        while (_stackMayEnd && place < _raw.Length && _raw[place] != ';')
        {
            var part = kind is null ? upper : lower;
            if (_raw[place] == '\\' && CharacterEscapes.LengthAt(_raw, place, out var meant) is > 0 and var escape)
            {
                part.Append(meant);
                place += escape;
            }
            else if (_raw[place] == '\\' && place + 1 < _raw.Length)
            {
                part.Append(_raw[place + 1] == '~' ? '\u00A0' : _raw[place + 1]);
                place += 2;
            }
            else if (SpecialCharacters.PercentLength(_raw, place, out var character, out _, out _) is > 0 and var percent)
            {
                part.Append(character);
                place += percent;
            }
            else
            {
                if (kind is null && SeparatorOf(_raw[place]) is { } found) kind = found;
                else if (_raw[place] >= ' ') part.Append(_raw[place]);
                place++;
            }
        }

        if (!_stackMayEnd || place >= _raw.Length)
        {
            _stackMayEnd = false; // a search for the end of each would take a time that grows with the square of the length
            _unknown.Add("\\S");
            return at + 2;
        }

        if (kind is { } separator) Add(MTextPieceKind.Stack, new MTextStack(upper.ToString().Trim(), lower.ToString().Trim(), separator));
        else Append(upper.ToString());
        return place + 1;
    }

    private static MTextStackKind? SeparatorOf(char character) => character switch
    {
        '^' => MTextStackKind.Tolerance,
        '/' => MTextStackKind.Horizontal,
        '#' => MTextStackKind.Diagonal,
        _ => null,
    };

    private void Append(char unit)
    {
        if (_run.Length > 0 && _runFormat != _format) EndRun();
        if (_run.Length == 0 && _runFormat != _format) _runFormat = _format;
        _run.Append(unit);
    }

    private void Append(string units)
    {
        foreach (var unit in units) Append(unit);
    }

    private void Add(MTextPieceKind kind, MTextStack? stack = null)
    {
        EndRun();
        if (_runFormat != _format) _runFormat = _format;
        _pieces.Add(new MTextPiece(kind, "", _runFormat, stack));
    }

    private void EndRun()
    {
        if (_run.Length == 0) return;
        _pieces.Add(new MTextPiece(MTextPieceKind.Text, _run.ToString(), _runFormat));
        _run.Clear();
    }

    private void EndParagraph()
    {
        EndRun();
        _paragraphs.Add(new MTextParagraph(_paragraph, [.. _pieces], _format));
        _pieces.Clear();
        _paragraph = _inherited;
    }
}
