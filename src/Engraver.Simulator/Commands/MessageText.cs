using System.Globalization;
using System.Text;
using Engraver.Simulator.Language;

namespace Engraver.Simulator.Commands;

/// <summary>MG: texts, values and formats (galil-dmc.md E Messages).</summary>
internal sealed class MessageText
{
    private const int LongestText = 76;
    private readonly StringBuilder text = new();
    private readonly StatementReader reader;
    private bool lineEnd = true;
    private bool afterNumber;
    private NumberFormat? pending;

    private MessageText(StatementReader reader) => this.reader = reader;

    public static void Write(StatementReader reader)
    {
        var message = new MessageText(reader);
        message.ReadItems();
        reader.Context.Output.Append(message.text).Append(message.lineEnd ? "\r\n" : "");
    }

    private void ReadItems()
    {
        while (!reader.IsAtEnd)
        {
            if (reader.Next == '{')
            {
                ReadBraces(null);
            }
            else if (reader.TryTake('"'))
            {
                AppendText(reader.TakeUntil('"', Tc.BadString));
            }
            else if (!reader.TryTake(',') && !reader.TryTake(' '))
            {
                ReadValue();
            }
        }
    }

    private void AppendText(string literal)
    {
        text.Append(literal.Length <= LongestText ? literal : throw new CommandRefusedException(Tc.BadString));
        afterNumber = false;
    }

    private void ReadValue()
    {
        var value = reader.TakeExpression();
        if (reader.Next == '{')
        {
            ReadBraces(value);
            return;
        }

        AppendNumber((pending ?? reader.Machine.ValueFormat).Print(value));
    }

    /// <summary>Every number has a sign column; between two numbers a minus gets a blank of its own.</summary>
    private void AppendNumber(string number)
    {
        text.Append(afterNumber && number[0] == '-' ? " " : "").Append(number);
        afterNumber = true;
    }

    /// <summary>{Fm.n} {Zm.n} {$m.n} {Sn} format a value; {N} {^n} {Ex} {P1} stand alone.</summary>
    private void ReadBraces(FixedPoint? value)
    {
        reader.Take('{', Tc.BadBraces);
        string body = reader.TakeUntil('}', Tc.BadBraces);
        char kind = body.Length > 0 ? body[0] : '\0';
        string rest = body.Length > 0 ? body[1..] : "";
        switch (kind)
        {
            case 'N' when rest.Length == 0:
                lineEnd = false;
                break;
            case '^':
                text.Append((char)(byte)Number(rest, 255));
                break;
            case 'E' when rest.Length == 1 && rest[0] is >= 'A' and <= 'H':
                reader.Context.OutputHandle = rest[0] - 'A';
                break;
            case 'P':
                reader.Context.OutputHandle = -1; // the serial port: nobody on Ethernet hears it
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

        if (value is { } plain)
        {
            AppendNumber((pending ?? reader.Machine.ValueFormat).Print(plain));
        }
    }

    private void ApplyFormat(NumberFormat format, FixedPoint? value)
    {
        if (value is { } number)
        {
            AppendNumber(format.Print(number));
        }
        else
        {
            pending = format;
        }
    }

    private static NumberFormat Format(char kind, string body)
    {
        string[] parts = body.Split('.');
        int digits = Number(parts[0], 10);
        int decimals = parts.Length > 1 ? Number(parts[1], 4) : 0;
        return new NumberFormat(Math.Max(1, digits), decimals, kind == 'F', kind == '$');
    }

    private static int Number(string digits, int largest) =>
        int.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number <= largest
            ? number
            : throw new CommandRefusedException(Tc.BadBraces);

    private static string Unpacked(FixedPoint value, int characters)
    {
        var result = new StringBuilder(6);
        for (int i = 0; i < characters; i++)
        {
            char c = (char)((value.Raw >> (40 - (8 * i))) & 0xFF);
            result.Append(c == '\0' ? "" : c);
        }

        return result.ToString();
    }
}
