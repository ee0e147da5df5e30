using System.Globalization;
using Engraver.Simulator.Language;
using Engraver.Simulator.Values;

namespace Engraver.Simulator;

/// <summary>CI (galil-dmc.md C.3): input on the serial port runs #COMINT in thread 0 and can be read as P1CH, P1ST, P1NM and P1CD.</summary>
/// <remarks>There is no queue: new input replaces input that the program has not read, and interrupts only while the interrupt is armed [U].</remarks>
internal sealed class SerialInterrupt
{
    private const int LongestText = 6;
    private readonly TextBuffer _line = new();
    private FixedPoint _text;
    private FixedPoint _number;

    /// <summary>CI, first field: 0 off, 1 at a carriage return, 2 at any character.</summary>
    public int When { get; private set; }

    /// <summary>CI, second field 1: input is data for the program and not a command.</summary>
    public bool TakesData { get; private set; }

    /// <summary>False while #COMINT runs; the second argument of its EN arms the interrupt again.</summary>
    public bool IsArmed { get; private set; }

    /// <summary>P1CD: -1 when CI is off, 0 when nothing was received, 1 for a character, 2 for a text that is not a number, 3 for a number.</summary>
    public int Code { get; private set; } = -1;

    /// <summary>P1CH: the last character, as a string of one character.</summary>
    public FixedPoint Character { get; private set; }

    public void Configure(int when, bool takesData)
    {
        When = when;
        TakesData = takesData && when != 0;
        IsArmed = when != 0;
        Clear();
    }

    /// <summary>CI -1: discards the received input.</summary>
    public void Clear()
    {
        _line.Clear();
        (_text, _number, Character) = (default, default, default);
        Code = When == 0 ? -1 : 0;
    }

    public void Rearm() => IsArmed = When != 0;

    /// <summary>P1ST: up to six characters of the line; reading it clears the code.</summary>
    public FixedPoint ReadText()
    {
        Code = Math.Min(Code, 0);
        return _text;
    }

    /// <summary>P1NM: the line as a number; reading it clears the code.</summary>
    public FixedPoint ReadNumber()
    {
        Code = Math.Min(Code, 0);
        return _number;
    }

    /// <summary>Takes one received character; returns true when #COMINT must be started.</summary>
    public bool Accept(char c)
    {
        if (When == 0 || c == '\n') return false;
        Character = NumberLiteral.PackText([c]);
        if (c == '\r') EndLine();
        else Keep(c);
        return IsArmed && (When == 2 || c == '\r');
    }

    public void Taken() => IsArmed = false;

    private void Keep(char c)
    {
        _line.Append(c);
        Code = 1;
    }

    private void EndLine()
    {
        var line = _line.Text;
        _text = NumberLiteral.PackText(line[..Math.Min(line.Length, LongestText)]);
        var isNumber = decimal.TryParse(line, NumberStyles.Number, CultureInfo.InvariantCulture, out var value) && Math.Abs(value) < int.MaxValue;
        _number = isNumber ? new FixedPoint((long)decimal.Truncate(value * 65536)) : default;
        Code = isNumber ? 3 : 2;
        _line.Clear();
    }
}
