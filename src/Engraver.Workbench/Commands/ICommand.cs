namespace Engraver.Workbench.Commands;

/// <summary>One command of the operator. A menu item, a key, a typed word, a script line and a test all run the same one.</summary>
public interface ICommand
{
    CommandInfo Info { get; }

    /// <summary>Asks for what it needs, then does it. A document step is taken at the very end, so that Esc anywhere leaves everything as it was.</summary>
    /// <exception cref="CommandException">It cannot be done; the sentence says why.</exception>
    Task RunAsync(CommandContext context, CancellationToken cancellation);
}

/// <summary>What a command is for; the order is that of the help.</summary>
public enum CommandGroup
{
    File,
    View,
    Ask,
    Drawing,
    Sequence,
    Trajectory,
    Output,
    Machine,
    Setting,
}

/// <summary>What is known of a command before it runs.</summary>
/// <param name="Name">In capitals, as it is typed.</param>
public sealed record CommandInfo(string Name, CommandGroup Group)
{
    /// <summary>One sentence for the help.</summary>
    public string Summary => Wording.Get("Command." + Name);

    /// <summary>True when it may be used inside another command, with an apostrophe before it, because it changes neither the drawing nor the
    /// machine.</summary>
    public bool Transparent { get; init; }

    /// <summary>True when machine parts may move: Enter never repeats it and no alias under 3 letters may stand for it.</summary>
    public bool StartsMotion { get; init; }

    /// <summary>True when it runs other commands, whatever they do.</summary>
    public bool RunsOthers { get; init; }

    /// <summary>True when it is heard while another command is at work, a job or a computation, though it may not be used inside one that asks. What it
    /// asks is asked beside the other.</summary>
    public bool HeardDuringJob { get; init; }

    /// <summary>False when Enter alone does not run it once more.</summary>
    public bool IsRepeated { get; init; } = true;

    /// <summary>True when it is run at once while another command is at work.</summary>
    public bool IsHeardBeside => HeardDuringJob || Transparent;

    /// <summary>True when another drawing is there behind it: what is typed about the view meanwhile is meant for that one.</summary>
    public bool BringsDrawing { get; init; }
}
