using System.Globalization;
using System.Text;

namespace Engraver.Links.Recording;

/// <summary>All bytes that a host sent to a controller over all its links, in order, with their times. Sent again at the same times, they move a machine in the
/// same way.</summary>
/// <param name="Clock">The clock of the times.</param>
/// <param name="Steps">In the order of their execution.</param>
/// <param name="IsWhole">False when the host did not reach the end of the recording.</param>
public sealed record Conversation(ConversationClock Clock, IReadOnlyList<ConversationStep> Steps, bool IsWhole)
{
    internal const string Title = "#wire;1;";
    internal const string End = "#end";

    /// <summary>The first line of the file.</summary>
    internal static string Header(ConversationClock clock) => Title + Word(clock);

    /// <summary>The times are exact: those of the controller itself.</summary>
    public bool IsControllersClock => Clock != ConversationClock.Wall;

    /// <summary>Reads the file. An incomplete last line, as a crash may leave it, is omitted.</summary>
    /// <exception cref="FormatException">The text is not a recording; the message names the line.</exception>
    public static Conversation Read(TextReader input)
    {
        ArgumentNullException.ThrowIfNull(input);
        if (input.ReadLine() is not { } first || !first.StartsWith(Title, StringComparison.Ordinal)) throw new FormatException(Wording.Get("Conversation.InvalidLine", 1));
        var (steps, whole, torn) = (new List<ConversationStep>(), false, 0);
        for (var line = 2; input.ReadLine() is { } text; line++)
        {
            if (torn > 0) throw new FormatException(Wording.Get("Conversation.InvalidLine", torn));
            whole = text == End;
            if (whole) continue;
            if (ConversationStep.TryParse(text) is { } step) steps.Add(step);
            else torn = line;
        }

        var clock = Enum.GetValues<ConversationClock>().Where(one => Word(one) == first[Title.Length..]).DefaultIfEmpty(ConversationClock.Wall).First();
        return new Conversation(clock, clock == ConversationClock.Wall ? steps : [.. steps.OrderBy(step => step.Ticks)], whole); // two threads record their bytes after sending them
    }

    private static string Word(ConversationClock clock) => clock switch { ConversationClock.Controller => "controller", ConversationClock.RealTime => "realtime", _ => "wall" };
}

/// <summary>The clock of the times of a recording.</summary>
public enum ConversationClock
{
    /// <summary>The wall clock of the host, from the start of the recording.</summary>
    Wall,

    /// <summary>The clock of a simulated controller that shares it, exact: time advanced through commands, and while the host waited.</summary>
    Controller,

    /// <summary>The clock of a simulated controller in real time, exact: commands took no time.</summary>
    RealTime,
}

/// <summary>An event on a link.</summary>
public enum ConversationAct
{
    Opened,
    Said,
    Closed,
}

/// <summary>One step of a recording.</summary>
/// <param name="Ticks">Time, 100 ns each.</param>
/// <param name="Link">Index of the link, from 0.</param>
/// <param name="Bytes">The sent bytes; empty for the other events.</param>
public sealed record ConversationStep(long Ticks, int Link, ConversationAct Act, byte[] Bytes)
{
    /// <summary>The step as a line: ticks, link, <c>+</c> opened, <c>&gt;</c> sent or <c>-</c> closed, and the sent bytes with <c>\r</c>, <c>\\</c> and
    /// <c>\xHH</c> for other bytes that are not printable.</summary>
    public override string ToString()
    {
        var line = new StringBuilder(Bytes.Length + 24).Append(Ticks.ToString(CultureInfo.InvariantCulture)).Append(' ').Append(Link.ToString(CultureInfo.InvariantCulture)).Append(Act switch { ConversationAct.Opened => " +", ConversationAct.Said => " > ", _ => " -" });
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
            ("+", 3) => new ConversationStep(ticks, link, ConversationAct.Opened, []),
            ("-", 3) => new ConversationStep(ticks, link, ConversationAct.Closed, []),
            (">", 4) when BytesOf(words[3]) is { } bytes => new ConversationStep(ticks, link, ConversationAct.Said, bytes),
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
