using Engraver.Simulator.Motion;

namespace Engraver.Simulator.Language;

/// <summary>Reads one compacted statement from left to right: names, fields and expressions (galil-dmc.md E).</summary>
internal sealed class StatementReader(string text, Machine machine, CommandContext context)
{
    private int _position;
    private int _depth;

    public Machine Machine => machine;

    public CommandContext Context => context;

    public bool IsAtEnd => _position >= text.Length;

    public char Next => _position < text.Length ? text[_position] : '\0';

    public void Skip(int characters)
    {
        _position += characters;
        TryTake(' ');
    }

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
        var rest = text[_position..];
        _position = text.Length;
        return rest;
    }

    public char TakeCharacter() => _position < text.Length ? text[_position++] : throw new CommandRefusedException(Tc.OperandError);

    public string TakeUntil(char end, int code)
    {
        var found = text.IndexOf(end, _position);
        if (found < 0) throw new CommandRefusedException(code);

        var taken = text[_position..found];
        _position = found + 1;
        return taken;
    }

    /// <summary>A letter followed by letters, digits and underscores; empty when there is none.</summary>
    public string TakeName()
    {
        var start = _position;
        while (char.IsAsciiLetterOrDigit(Next) || (Next == '_' && _position > start)) _position++;

        return text[start.._position];
    }

    /// <summary>Comma separated fields up to the end, or up to "&lt;" or "&gt;" of a segment speed.</summary>
    public List<Field> TakeFields(bool comparisons = true)
    {
        var fields = new List<Field>(4);
        while (true)
        {
            fields.Add(TakeField(comparisons));
            if (!TryTake(',')) return fields;
        }
    }

    public Field TakeField(bool comparisons = true)
    {
        if (IsAtEnd || Next == ',' || (!comparisons && Next is '<' or '>')) return default;

        return TryTake('?') ? new Field(true, null) : new Field(false, TakeExpression(comparisons));
    }

    /// <summary>An expression strictly from left to right, no precedence.</summary>
    /// <param name="comparisons">False where "&lt;" and "&gt;" introduce speeds (VP, CR, LI); inside parentheses they compare again.</param>
    public FixedPoint TakeExpression(bool comparisons = true)
    {
        var value = TakeOperand();
        while (TakeOperator(comparisons) is { } apply) value = apply(value, TakeOperand());

        return value;
    }

    private Func<FixedPoint, FixedPoint, FixedPoint>? TakeOperator(bool comparisons)
    {
        var c = Next;
        if (c is '<' or '>' or '=' && !comparisons) return null;

        Func<FixedPoint, FixedPoint, FixedPoint>? apply = c switch
        {
            '+' => static (a, b) => a + b,
            '-' => static (a, b) => a - b,
            '*' => static (a, b) => a * b,
            '/' => static (a, b) => a / b,
            '&' => static (a, b) => a & b,
            '|' => static (a, b) => a | b,
            '=' => static (a, b) => FixedPoint.FromBoolean(a == b),
            '<' => static (a, b) => FixedPoint.FromBoolean(a < b),
            '>' => static (a, b) => FixedPoint.FromBoolean(a > b),
            _ => null,
        };
        _position += apply is null ? 0 : 1;
        return c switch
        {
            '<' when TryTake('=') => static (a, b) => FixedPoint.FromBoolean(a <= b),
            '<' when TryTake('>') => static (a, b) => FixedPoint.FromBoolean(a != b),
            '>' when TryTake('=') => static (a, b) => FixedPoint.FromBoolean(a >= b),
            _ => apply,
        };
    }

    private FixedPoint TakeOperand()
    {
        var c = Next;
        if (char.IsAsciiDigit(c) || c is '.' or '$') return TakeNumber();

        switch (c)
        {
            case '-':
                _position++;
                return -TakeOperand();
            case '+':
                _position++;
                return TakeOperand();
            case '(':
                return TakeParentheses();
            case '@':
                _position++;
                return Functions.Evaluate(this);
            case '_':
                _position++;
                return Operands.Evaluate(machine, context, TakeName());
            case '"':
                _position++;
                return NumberLiteral.PackText(TakeUntil('"', Tc.BadString));
        }

        return char.IsAsciiLetter(c) ? TakeVariable() : throw new CommandRefusedException(Tc.OperandError);
    }

    private FixedPoint TakeParentheses()
    {
        if (++_depth > 32) throw new CommandRefusedException(Tc.Parentheses);

        Take('(', Tc.Parentheses);
        var value = TakeExpression();
        Take(')', Tc.Parentheses);
        _depth--;
        return value;
    }

    private FixedPoint TakeVariable()
    {
        var name = TakeName();
        if (Next == '[')
        {
            var array = machine.Variables.ArrayNamed(name);
            var index = TakeIndex();
            return index == -1 ? FixedPoint.FromInteger(array.Length) : array[Checked(index, array)];
        }

        return name == "TIME" ? FixedPoint.FromInteger((int)machine.Sample) : machine.Variables.Read(name);
    }

    /// <summary>The index in brackets behind an array name.</summary>
    public int TakeIndex()
    {
        Take('[', Tc.MissingBracket);
        var index = TakeExpression().Integer;
        Take(']', Tc.MissingBracket);
        return index;
    }

    public static int Checked(int index, FixedPoint[] array) =>
        index >= 0 && index < array.Length ? index : throw new CommandRefusedException(Tc.BadIndex);

    private FixedPoint TakeNumber()
    {
        var value = NumberLiteral.Read(text.AsSpan(_position), out var length);
        _position += length;
        return value;
    }

    /// <summary>Axis and plane letters up to the end or an equals sign; commas between them are ignored (L.2 point 8). Empty means none were named.</summary>
    public AxisSelection TakeAxes()
    {
        var selection = new AxisSelection(machine.Motion);
        while (!IsAtEnd && Next != '=')
        {
            var c = text[_position++];
            if (c is not (',' or ' ')) selection.Add(c);
        }

        return selection;
    }
}
