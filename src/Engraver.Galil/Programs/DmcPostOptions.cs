namespace Engraver.Galil.Programs;

/// <summary>What a post needs to know beside the motion program.</summary>
public sealed record DmcPostOptions
{
    public static DmcPostOptions Default { get; } = new();

    /// <summary>What the controller's position reads when the machine stands at the start of the job (counts). Rapids are absolute and count from here.</summary>
    public CountsPoint ControllerAtStart { get; init; }

    /// <summary>Lines the controller's program memory holds, subprograms included; a longer job comes in chunks.</summary>
    public int MemoryLines { get; init; } = DmcLimits.ProgramLines;
}
