using System.Globalization;
using System.Text;

namespace Engraver.Links.Recording;

/// <summary>One step of a recording.</summary>
/// <param name="Ticks">Time, 100 ns each.</param>
/// <param name="Link">Index of the link, from 0.</param>
/// <param name="Bytes">The sent bytes; empty for the other events.</param>
public sealed record ConversationStep(long Ticks, int Link, ConversationEvent Event, byte[] Bytes)
{
    /// <summary>The step as a line: ticks, link, <c>+</c> opened, <c>&gt;</c> sent or <c>-</c> closed, and the sent bytes with <c>\r</c>, <c>\\</c> and
    /// <c>\xHH</c> for other bytes that are not printable.</summary>
    public override string ToString()
    {
        var line = new StringBuilder(Bytes.Length + 24).Append(Ticks.ToString(CultureInfo.InvariantCulture)).Append(' ').Append(Link.ToString(CultureInfo.InvariantCulture)).Append(Event switch { ConversationEvent.Opened => " +", ConversationEvent.Said => " > ", _ => " -" });
        foreach (var one in Bytes)
        {
            if (one is >= 0x20 and < 0x7F and not (byte)'\\') line.Append((char)one);
            else if (one is (byte)'\r') line.Append("\\r");
            else if (one is (byte)'\\') line.Append("\\\\");
            else line.Append("\\x").Append(one.ToString("x2", CultureInfo.InvariantCulture));
        }

        return line.ToString();
    }

    /// <returns>Null when the line is not a step.</returns>
    internal static ConversationStep? TryParse(string line)
    {
        var words = line.Split(' ', 4);
        if (words.Length < 3 || !long.TryParse(words[0], NumberStyles.None, CultureInfo.InvariantCulture, out var ticks) || !int.TryParse(words[1], NumberStyles.None, CultureInfo.InvariantCulture, out var link)) return null;
        return (words[2], words.Length) switch
        {
            ("+", 3) => new ConversationStep(ticks, link, ConversationEvent.Opened, []),
            ("-", 3) => new ConversationStep(ticks, link, ConversationEvent.Closed, []),
            (">", 4) when BytesOf(words[3]) is { } bytes => new ConversationStep(ticks, link, ConversationEvent.Said, bytes),
            _ => null,
        };
    }

    private static byte[]? BytesOf(string text)
    {
        var bytes = new List<byte>(text.Length);
        for (var i = 0; i < text.Length; i++)
        {
            if (text[i] is < ' ' or > '~') return null;
            if (text[i] != '\\')
            {
                bytes.Add((byte)text[i]);
                continue;
            }

            if (++i == text.Length) return null;
            if (text[i] is 'r' or '\\') bytes.Add(text[i] == 'r' ? (byte)'\r' : (byte)'\\');
            else if (text[i] == 'x' && i + 2 < text.Length && byte.TryParse(text.AsSpan(i + 1, 2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var other)) (bytes, i) = (Added(bytes, other), i + 2);
            else return null;
        }

        return [.. bytes];
    }

    private static List<byte> Added(List<byte> bytes, byte one)
    {
        bytes.Add(one);
        return bytes;
    }
}
