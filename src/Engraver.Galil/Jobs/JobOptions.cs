namespace Engraver.Galil.Jobs;

public sealed record JobOptions
{
    public JobMode Mode { get; init; } = JobMode.Stream;

    /// <summary>Where progress is written as JSON lines, or null for nowhere. The program found in the controller is kept beside it, with <c>.program.dmc</c> added to the name.</summary>
    public string? JournalPath { get; init; }

    /// <summary>Name of the drawing for the journal.</summary>
    public string DrawingName { get; init; } = "";

    /// <summary>Every motion is made, but the tool output is never switched on.</summary>
    public bool DryRun { get; init; }

    /// <summary>Pause between two polls while the controller works on its own. Zero for the simulator at full speed, whose time is the commands it receives.
    /// While a sequence is open the feeder never pauses.</summary>
    public TimeSpan PollInterval { get; init; } = TimeSpan.FromMilliseconds(10);
}
