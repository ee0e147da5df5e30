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
