using Engraver.Core.Diagnostics;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Stages;

/// <summary>A job whose drawing has the letters of its texts as curves, if they are to be cut.</summary>
public record LetteredJob : DrawnJob
{
    public LetteredJob(DrawnJob job, LetteredDrawing letters)
        : base(job) => Letters = letters;

    /// <summary>The texts that are cut, and their fonts.</summary>
    public LetteredDrawing Letters { get; init; }

    /// <summary>Fields in these texts that have no value (SER0001, SER0002, SER0004). With such a field there is no motion program.</summary>
    public IReadOnlyList<Diagnostic> FieldFaults { get; init; } = [];
}
