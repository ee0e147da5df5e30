namespace Engraver.Workbench.Commands;

/// <summary>A command. Menu items, keys, typed input, scripts and tests run the same commands.</summary>
public interface ICommand
{
    CommandInfo Info { get; }

    /// <summary>Prompts for its input, then runs. The document step is committed at the end, so that Esc at any prompt leaves the document unchanged.</summary>
    /// <exception cref="CommandException">The command failed; the message states the reason.</exception>
    Task RunAsync(CommandContext context, CancellationToken cancellation);
}

/// <summary>Groups of commands, in the order of the help.</summary>
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

/// <summary>Static properties of a command.</summary>
/// <param name="Name">In capitals, as typed.</param>
public sealed record CommandInfo(string Name, CommandGroup Group)
{
    /// <summary>One sentence for the help.</summary>
    public string Summary => Wording.Get("Command." + Name);

    /// <summary>True if it may be nested in another command, with an apostrophe before it, because it changes neither the drawing nor the machine.</summary>
    public bool Transparent { get; init; }

    /// <summary>True if the machine may move: Enter does not repeat it and its aliases have at least 3 letters.</summary>
    public bool StartsMotion { get; init; }

    /// <summary>True if it runs other commands.</summary>
    public bool RunsOthers { get; init; }

    /// <summary>True if it may run while another command works (a job or a computation), but not nested in a prompting one. Its prompts appear
    /// concurrently.</summary>
    public bool HeardDuringJob { get; init; }

    /// <summary>False if Enter alone does not repeat it.</summary>
    public bool IsRepeated { get; init; } = true;

    /// <summary>True if it runs at once while another command works.</summary>
    public bool IsHeardBeside => HeardDuringJob || Transparent;

    /// <summary>True if it opens another drawing: view commands typed meanwhile apply to the new drawing.</summary>
    public bool BringsDrawing { get; init; }
}
