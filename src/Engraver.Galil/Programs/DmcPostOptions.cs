namespace Engraver.Galil.Programs;

/// <summary>What a post needs to know beside the motion program.</summary>
public sealed record DmcPostOptions
{
    public static DmcPostOptions Default { get; } = new();

    /// <summary>Lines the controller's program memory holds, subprograms included; a longer job comes in chunks.</summary>
    public int MemoryLines { get; init; } = DmcLimits.ProgramLines;
}
