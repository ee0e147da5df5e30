using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Inputs of a post in addition to the motion program.</summary>
public sealed record DmcPostOptions
{
    public static DmcPostOptions Default { get; } = new();

    /// <summary>Number of lines of the controller's program memory, including subprograms; a longer job is written in chunks.</summary>
    public int MemoryLines { get; init; } = DmcLimits.ProgramLines;

    /// <summary>The program supervises itself and ends with the tool off in every case, with no host connected (<see cref="UnattendedProgram"/>).</summary>
    public bool Unattended { get; init; }

    /// <summary>The drawing's zero by the controller's own zero, counts; null: the drawing's start point is the position of the machine at the start of the
    /// job.</summary>
    public PostOrigin? Origin { get; init; }
}
