using System.Globalization;
using System.Text;

namespace Engraver.Links.Recording;

/// <summary>What a host said to a controller over all its links: every byte, in order, with the time. Said again at the same times it moves a machine as it
/// did.</summary>
/// <param name="Clock">Whose times they are.</param>
/// <param name="Steps">In the order in which they were done.</param>
/// <param name="IsWhole">False where the host did not come to the end of it.</param>
public sealed record Conversation(ConversationClock Clock, IReadOnlyList<ConversationStep> Steps, bool IsWhole)
{
    internal const string Title = "#wire;1;";
    internal const string End = "#end";

    /// <summary>The first line of the file.</summary>
    internal static string Header(ConversationClock clock) => Title + Word(clock);

    /// <summary>The times are exact: those of the controller itself.</summary>
    public bool IsControllersClock => Clock != ConversationClock.Wall;

    /// <summary>Reads the file. A last line that was cut off, as a crash may leave it, is left out.</summary>
    /// <exception cref="FormatException">The text is something else; the message names the line.</exception>
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
        return new Conversation(clock, clock == ConversationClock.Wall ? steps : [.. steps.OrderBy(step => step.Ticks)], whole); // two threads note what they said after they said it
    }

    private static string Word(ConversationClock clock) => clock switch { ConversationClock.Controller => "controller", ConversationClock.RealTime => "realtime", _ => "wall" };
}

/// <summary>Whose times a conversation has.</summary>
public enum ConversationClock
{
    /// <summary>Those of the host's wall, from the beginning of the conversation.</summary>
    Wall,

    /// <summary>Those of a simulated controller that gave its clock, exact: time passed by the commands, and while the host waited.</summary>
    Controller,

    /// <summary>Those of a simulated controller in real time, exact: commands took none of it.</summary>
    RealTime,
}

/// <summary>What is done on a link.</summary>
public enum ConversationAct
{
    Opened,
    Said,
    Closed,
}

/// <summary>One step of a conversation.</summary>
/// <param name="Ticks">When, 100 ns each.</param>
/// <param name="Link">The first link is 0.</param>
/// <param name="Bytes">What was said; empty for the other acts.</param>
public sealed record ConversationStep(long Ticks, int Link, ConversationAct Act, byte[] Bytes)
{
    /// <summary>The step as a line: ticks, link, <c>+</c> opened, <c>&gt;</c> said or <c>-</c> closed, and what was said with <c>\r</c>, <c>\\</c> and
    /// <c>\xHH</c> for other bytes that are no visible letters.</summary>
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

    /// <returns>Null when the line is none.</returns>
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
