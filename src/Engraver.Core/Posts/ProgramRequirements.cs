namespace Engraver.Core.Posts;

/// <summary>Requirements of a job for its program in addition to the path and the settings of the machine: the options of the post, which no drawing
/// contains.</summary>
public sealed record ProgramRequirements
{
    /// <summary>G-code of the work offset of all positions: G54 to G59.</summary>
    public required string WorkOffset { get; init; }

    /// <summary>G-code that switches the tool when no axis moves it: m3, m4, m8 or m64.</summary>
    public required string ToolSwitch { get; init; }

    /// <summary>S word of G-code, for the spindle or the device that M3 or M4 switches: of a beam that of full power.</summary>
    public required double SpindleSpeed { get; init; }

    /// <summary>Pen of HP-GL, 1 to 8.</summary>
    public required int Pen { get; init; }
}
