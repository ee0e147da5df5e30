using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>Values: strictly from left to right, no precedence (galil-dmc.md E Evaluation).</summary>
internal static class Expressions
{
    private const int DeepestParentheses = 32;

    /// <summary>An expression strictly from left to right, no precedence.</summary>
    /// <param name="comparisons">False where "&lt;" and "&gt;" introduce speeds (VP, CR, LI); inside parentheses they are comparisons again.</param>
    public static FixedPoint Take(StatementReader reader, bool comparisons)
    {
        var value = TakeOperand(reader);
        while (TakeOperator(reader, comparisons) is { } apply) value = apply(value, TakeOperand(reader));
        return value;
    }

    private static Func<FixedPoint, FixedPoint, FixedPoint>? TakeOperator(StatementReader reader, bool comparisons)
    {
        var c = reader.Next;
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
        reader.Advance(apply is null ? 0 : 1);
        return c switch
        {
            '<' when reader.TryTake('=') => static (a, b) => FixedPoint.FromBoolean(a <= b),
            '<' when reader.TryTake('>') => static (a, b) => FixedPoint.FromBoolean(a != b),
            '>' when reader.TryTake('=') => static (a, b) => FixedPoint.FromBoolean(a >= b),
            _ => apply,
        };
    }

    private static FixedPoint TakeOperand(StatementReader reader)
    {
        var c = reader.Next;
        if (char.IsAsciiDigit(c) || c is '.' or '$') return TakeNumber(reader);
        if (char.IsAsciiLetter(c)) return TakeVariable(reader);
        if (c == '(') return TakeParentheses(reader);
        reader.Advance(1);
        return c switch
        {
            '-' => -TakeOperand(reader),
            '+' => TakeOperand(reader),
            '@' => Functions.Evaluate(reader),
            '_' => Operands.Take(reader),
            '~' => FixedPoint.FromInteger(reader.Machine.VariableAxes[reader.TakeCharacter()]),
            '"' => NumberLiteral.PackText(reader.TakeUntil('"', Tc.BadString)),
            _ => throw new CommandRefusedException(Tc.OperandError),
        };
    }

    private static FixedPoint TakeParentheses(StatementReader reader)
    {
        if (++reader.Depth > DeepestParentheses) throw new CommandRefusedException(Tc.Parentheses);
        reader.Take('(', Tc.Parentheses);
        var value = Take(reader, comparisons: true);
        reader.Take(')', Tc.Parentheses);
        reader.Depth--;
        return value;
    }

    private static FixedPoint TakeVariable(StatementReader reader)
    {
        var name = reader.TakeName();
        var machine = reader.Machine;
        if (reader.Next != '[') return Keywords.TryRead(machine, name, out var value) ? value : machine.Variables.Read(name);
        var array = machine.Variables.ArrayNamed(name);
        var index = reader.TakeIndex();
        return index == -1 ? FixedPoint.FromInteger(array.Length) : array[StatementReader.Checked(index, array)];
    }

    private static FixedPoint TakeNumber(StatementReader reader)
    {
        var value = NumberLiteral.Read(reader.Rest, out var length);
        reader.Advance(length);
        return value;
    }
}
