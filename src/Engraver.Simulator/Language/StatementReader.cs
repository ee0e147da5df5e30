using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>Reads one compacted statement from left to right: characters, names, fields (galil-dmc.md E). One reader serves one statement after the
/// other.</summary>
internal sealed class StatementReader(Machine machine)
{
    private readonly List<Field> _fields = new(8);
    private string _text = "";
    private int _position;
    private CommandContext? _context;

    public Machine Machine => machine;

    public CommandContext Context => _context!;

    public bool IsAtEnd => _position >= _text.Length;

    public char Next => _position < _text.Length ? _text[_position] : '\0';

    /// <summary>The text that has not been read yet.</summary>
    public ReadOnlySpan<char> Rest => _text.AsSpan(_position);

    /// <summary>Number of parentheses and brackets that are open at the reading position.</summary>
    public int Depth { get; set; }

    public StatementReader On(string text, CommandContext context)
    {
        _text = text;
        _context = context;
        _position = 0;
        Depth = 0;
        return this;
    }

    public void Skip(int characters)
    {
        _position += characters;
        TryTake(' ');
    }

    public void Advance(int characters) => _position += characters;

    public bool TryTake(char c)
    {
        if (Next != c) return false;
        _position++;
        return true;
    }

    public void Take(char c, int code)
    {
        if (!TryTake(c)) throw new CommandRefusedException(code);
    }

    public void ExpectEnd()
    {
        if (!IsAtEnd) throw new CommandRefusedException(Tc.OperandError);
    }

    public string TakeRest()
    {
        var rest = _text[_position..];
        _position = _text.Length;
        return rest;
    }

    public char TakeCharacter() => _position < _text.Length ? _text[_position++] : throw new CommandRefusedException(Tc.OperandError);

    public ReadOnlySpan<char> TakeUntil(char end, int code)
    {
        var found = _text.IndexOf(end, _position);
        if (found < 0) throw new CommandRefusedException(code);
        var taken = _text.AsSpan(_position, found - _position);
        _position = found + 1;
        return taken;
    }

    /// <summary>A letter followed by letters, digits and underscores; empty when there is none.</summary>
    public ReadOnlySpan<char> TakeName()
    {
        var start = _position;
        while (char.IsAsciiLetterOrDigit(Next) || (Next == '_' && _position > start)) _position++;
        return _text.AsSpan(start, _position - start);
    }

    /// <summary>Comma separated fields up to the end, or up to the "&lt;" or "&gt;" of a segment speed. The list belongs to the reader and is overwritten by
    /// the next call.</summary>
    public List<Field> TakeFields(bool comparisons = true)
    {
        _fields.Clear();
        do
        {
            _fields.Add(TakeField(comparisons));
        }
        while (TryTake(','));
        return _fields;
    }

    public Field TakeField(bool comparisons = true) =>
        IsAtEnd || Next == ',' || (!comparisons && Next is '<' or '>') ? default
        : TryTake('?') ? new Field(true, null)
        : new Field(false, TakeExpression(comparisons));

    /// <inheritdoc cref="Expressions.Take"/>
    public FixedPoint TakeExpression(bool comparisons = true) => Expressions.Take(this, comparisons);

    /// <summary>The index in brackets after an array name.</summary>
    public int TakeIndex()
    {
        Take('[', Tc.MissingBracket);
        var index = TakeExpression().Integer;
        Take(']', Tc.MissingBracket);
        return index;
    }

    public static int Checked(int index, FixedPoint[] array) =>
        index >= 0 && index < array.Length ? index : throw new CommandRefusedException(Tc.BadIndex);

    /// <summary>Axis and plane letters up to the end or an equals sign; commas between them are ignored (L.2 point 8). Empty means none were named.</summary>
    public AxisSelection TakeAxes()
    {
        var selection = new AxisSelection(machine.Motion);
        while (!IsAtEnd && Next != '=')
        {
            var c = TakeLetter();
            if (c is not (',' or ' ')) selection.Add(c);
        }

        return selection;
    }

    /// <summary>The letter of an axis or plane, also through a variable axis <c>~a</c> to <c>~h</c> (E: 0-7 axes, 8 and 9 planes, 10 and 11 virtual
    /// axes).</summary>
    public char TakeLetter() => TryTake('~') ? machine.VariableAxes.LetterOf(TakeCharacter()) : TakeCharacter();
}
