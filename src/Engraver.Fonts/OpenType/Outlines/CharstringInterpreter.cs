namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>Runs the program of one glyph (Adobe TN 5177, "The Type 2 charstring format"). Hints are skipped.</summary>
/// <remarks>Not supported, and therefore a <see cref="BrokenFontException"/>: arithmetic operators, and accented letters composed by endchar. Fonts in use
/// today do without them.</remarks>
internal sealed class CharstringInterpreter(IOutlineSink sink, CffIndex globalSubroutines, CffIndex localSubroutines)
{
    private const int MaxCallDepth = 10;
    private const int MaxOperands = 513;

    /// <summary>More numbers and operators than any glyph has; subroutines that call each other in vast numbers end here.</summary>
    private const int MaxSteps = 500_000;

    /// <summary>Operands of an endchar that composes two glyphs.</summary>
    private const int OperandsOfComposition = 4;

    private readonly double[] _stack = new double[MaxOperands];
    private readonly CharstringPen _pen = new(sink);
    private int _count;
    private int _hints;
    private int _steps;
    private bool _isEnded;

    public void Run(FontBytes charstring)
    {
        Run(charstring, 0);
        _pen.EndFigure();
    }

    private void Run(FontBytes code, int depth)
    {
        if (depth > MaxCallDepth)
            throw new BrokenFontException("The subroutines of a glyph call each other too deeply.");
        for (var offset = 0; offset < code.Length && !_isEnded;)
        {
            if (++_steps > MaxSteps)
                throw new BrokenFontException("The program of a glyph is too long.");
            int first = code.Byte(offset++);
            if (first >= 32 || first == (int)CharstringOperator.Short)
            {
                Push(Number(code, first, ref offset));
                continue;
            }
            var operation = (CharstringOperator)(first == 12 ? 1200 + code.Byte(offset++) : first);
            if (operation == CharstringOperator.Return)
                return;
            Perform(operation, code, ref offset, depth);
        }
    }

    private void Perform(CharstringOperator operation, FontBytes code, ref int offset, int depth)
    {
        switch (operation)
        {
            case CharstringOperator.HStem or CharstringOperator.VStem or CharstringOperator.HStemHm or CharstringOperator.VStemHm:
                _hints += _count / 2;
                _count = 0;
                break;
            case CharstringOperator.HintMask or CharstringOperator.CounterMask:
                _hints += _count / 2;
                _count = 0;
                offset += (_hints + 7) / 8;
                break;
            case CharstringOperator.CallSubroutine:
                Call(localSubroutines, depth);
                break;
            case CharstringOperator.CallGlobalSubroutine:
                Call(globalSubroutines, depth);
                break;
            case CharstringOperator.EndChar when _count >= OperandsOfComposition:
                throw new BrokenFontException("A glyph is composed by an operator that is not supported.");
            case CharstringOperator.EndChar:
                _isEnded = true;
                break;
            default:
                _pen.Draw(operation, _stack.AsSpan(0, _count));
                _count = 0;
                break;
        }
    }

    /// <summary>Calls a subroutine. Numbers are stored minus a bias that depends on the number of subroutines.</summary>
    private void Call(CffIndex subroutines, int depth)
    {
        if (_count == 0)
            throw new BrokenFontException("A glyph calls a subroutine without saying which.");
        var bias = subroutines.Count < 1240 ? 107 : subroutines.Count < 33900 ? 1131 : 32768;
        Run(subroutines[(int)_stack[--_count] + bias], depth + 1);
    }

    private void Push(double value)
    {
        if (_count == MaxOperands)
            throw new BrokenFontException("A glyph has too many operands.");
        _stack[_count++] = value;
    }

    private static double Number(FontBytes code, int first, ref int offset)
    {
        switch (first)
        {
            case (int)CharstringOperator.Short:
                offset += 2;
                return code.Int16(offset - 2);
            case <= 246:
                return first - 139;
            case <= 250:
                return (first - 247) * 256 + code.Byte(offset++) + 108;
            case <= 254:
                return -(first - 251) * 256 - code.Byte(offset++) - 108;
            default:
                offset += 4;
                return (int)code.UInt32(offset - 4) / 65536.0;
        }
    }
}
