namespace Engraver.Galil.Terminals;

/// <summary>The request in a line typed into the terminal. The terminal's own words are lower case, the controller's commands upper case, so that they cannot
/// be confused.</summary>
public abstract record TerminalLine
{
    /// <summary>The word to type before a dangerous command.</summary>
    public const string ConfirmWord = "confirm";

    private TerminalLine()
    {
    }

    /// <summary>Parses a line. Commands that would block the conversation (downloads, binary replies) or that are dangerous are not sent.</summary>
    public static TerminalLine Read(string line)
    {
        var text = line.Trim();
        if (text is "quit" or "exit") return new Quit();
        if (text is "history") return new History();
        if (text is "help" || text.StartsWith("help ", StringComparison.Ordinal)) return new Help(text["help".Length..].Trim());
        var confirmed = text.StartsWith(ConfirmWord + " ", StringComparison.Ordinal);
        var command = confirmed ? text[ConfirmWord.Length..].Trim() : text;
        return CommandGuard.ReasonToWithhold(command, confirmed) is { } why ? new Withheld(why) : new ToSend(command);
    }

    /// <summary>A line for the controller; an empty one is a carriage return alone, which is answered with a prompt.</summary>
    public sealed record ToSend(string Text) : TerminalLine;

    /// <summary>A line that is not sent, and the reason.</summary>
    public sealed record Withheld(string Why) : TerminalLine;

    /// <param name="About">A command, the number of a TC code, or empty for the terminal itself.</param>
    public sealed record Help(string About) : TerminalLine;

    public sealed record History : TerminalLine;

    public sealed record Quit : TerminalLine;
}
