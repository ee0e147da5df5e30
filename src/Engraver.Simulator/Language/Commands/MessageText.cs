using System.Globalization;
using System.Text;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>MG: texts, values and formats (galil-dmc.md E Messages).</summary>
internal sealed class MessageText
{
    private const int LongestText = 76;
    private readonly TextBuffer _text;
    private readonly StatementReader _reader;
    private bool _lineEnd = true;
    private bool _afterNumber;
    private NumberFormat? _pending;

    private MessageText(StatementReader reader)
    {
        _reader = reader;
        _text = reader.Context.Output;
    }

    public static void Write(StatementReader reader)
    {
        var message = new MessageText(reader);
        message.ReadItems();
        if (message._lineEnd) reader.Context.Output.Append("\r\n");
    }

    private void ReadItems()
    {
        while (!_reader.IsAtEnd)
        {
            if (_reader.Next == '{')
            {
                ReadBraces(null);
            }
            else if (_reader.TryTake('"'))
            {
                AppendText(_reader.TakeUntil('"', Tc.BadString));
            }
            else if (!_reader.TryTake(',') && !_reader.TryTake(' '))
            {
                ReadValue();
            }
        }
    }

    private void AppendText(ReadOnlySpan<char> literal)
    {
        if (literal.Length > LongestText) throw new CommandRefusedException(Tc.BadString);
        _text.Append(literal);
        _afterNumber = false;
    }

    private void ReadValue()
    {
        var value = _reader.TakeExpression();
        if (_reader.Next == '{')
        {
            ReadBraces(value);
            return;
        }

        AppendNumber(_pending ?? _reader.Machine.ValueFormat, value);
    }

    /// <summary>Prints a number with its sign column; before a negative number that follows another number, also a blank if the controller prints one
    /// (<see cref="NumberSpacing"/>).</summary>
    private void AppendNumber(NumberFormat format, FixedPoint value)
    {
        if (_afterNumber && value.Raw < 0 && !format.Hex && _reader.Machine.Options.NumberSpacing == NumberSpacing.Blank) _text.Append(' ');
        _reader.Context.WriteNumber(format, value);
        _afterNumber = true;
    }

    /// <summary>{Fm.n} {Zm.n} {$m.n} {Sn} format a value; {N} {^n} {Ex} {P1} are used without a value.</summary>
    private void ReadBraces(FixedPoint? value)
    {
        _reader.Take('{', Tc.BadBraces);
        var body = _reader.TakeUntil('}', Tc.BadBraces);
        var kind = body.Length > 0 ? body[0] : '\0';
        var rest = body.Length > 0 ? body[1..].ToString() : "";
        switch (kind)
        {
            case 'N' when rest.Length == 0:
                _lineEnd = false;
                break;
            case '^':
                _text.Append((char)(byte)Number(rest, 255));
                break;
            case 'E' when rest.Length == 1 && rest[0] is >= 'A' and <= 'H':
                _reader.Context.OutputHandle = rest[0] - 'A';
                break;
            case 'P' when rest == "1":
                _reader.Context.OutputHandle = -1; // the serial port: no host on Ethernet receives it
                break;
            case 'S':
                AppendText(Unpacked(value ?? throw new CommandRefusedException(Tc.BadBraces), rest.Length == 0 ? 6 : Number(rest, 6)));
                return;
            case 'F' or 'Z' or '$':
                ApplyFormat(Format(kind, rest), value);
                return;
            default:
                throw new CommandRefusedException(Tc.BadBraces);
        }

        if (value is { } plain) AppendNumber(_pending ?? _reader.Machine.ValueFormat, plain);
    }

    private void ApplyFormat(NumberFormat format, FixedPoint? value)
    {
        if (value is { } number)
        {
            AppendNumber(format, number);
        }
        else
        {
            _pending = format;
        }
    }

    private static NumberFormat Format(char kind, string body)
    {
        var parts = body.Split('.');
        var digits = Number(parts[0], 10);
        var decimals = parts.Length > 1 ? Number(parts[1], 4) : 0;
        return new NumberFormat(Math.Max(1, digits), decimals, kind == 'F', kind == '$');
    }

    private static int Number(string digits, int largest) =>
        int.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out var number) && number <= largest
            ? number
            : throw new CommandRefusedException(Tc.BadBraces);

    private static string Unpacked(FixedPoint value, int characters)
    {
        var result = new StringBuilder(6);
        for (var i = 0; i < characters; i++)
        {
            var c = (char)((value.Raw >> (40 - (8 * i))) & 0xFF);
            result.Append(c == '\0' ? "" : c);
        }

        return result.ToString();
    }
}
