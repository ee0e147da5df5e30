namespace Engraver.Workbench.Commands;

/// <summary>What is known of a command before it runs.</summary>
/// <param name="Name">In capitals, as it is typed.</param>
/// <param name="Summary">One sentence for the help.</param>
public sealed record CommandInfo(string Name, CommandGroup Group, string Summary)
{
    /// <summary>True when it may be used inside another command, with an apostrophe before it: it only looks.</summary>
    public bool Transparent { get; init; }

    /// <summary>True when machine parts may move: Enter never repeats it and no alias under 3 letters may stand for it.</summary>
    public bool StartsMotion { get; init; }

    /// <summary>True when it is heard while a job runs; it must not ask anything.</summary>
    public bool HeardDuringJob { get; init; }
}
