namespace Engraver.Workbench.Commands;

/// <summary>Static properties of a command.</summary>
/// <param name="Name">In capitals, as typed.</param>
public sealed record CommandInfo(string Name, CommandGroup Group)
{
    /// <summary>One sentence for the help.</summary>
    public string Summary => Wording.Get("Command." + Name);

    /// <summary>True if it may be nested in another command, with an apostrophe before it, because it changes neither the drawing nor the machine.</summary>
    public bool IsTransparent { get; init; }

    /// <summary>True if the machine may move: Enter does not repeat it and its aliases have at least 3 letters.</summary>
    public bool StartsMotion { get; init; }

    /// <summary>True if it runs other commands.</summary>
    public bool RunsOtherCommands { get; init; }

    /// <summary>True if it may run while another command works (a job or a computation), but not nested in a prompting one. Its prompts appear
    /// concurrently.</summary>
    public bool IsAllowedDuringJob { get; init; }

    /// <summary>False if Enter alone does not repeat it.</summary>
    public bool IsRepeatable { get; init; } = true;

    /// <summary>True if it runs at once while another command works.</summary>
    public bool CanRunConcurrently => IsAllowedDuringJob || IsTransparent;

    /// <summary>True if it opens another drawing: view commands typed meanwhile apply to the new drawing.</summary>
    public bool ReplacesDrawing { get; init; }
}
