using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Stages;

/// <summary>A job whose drawing has the letters of its texts as curves, if they are to be cut.</summary>
public record LetteredJob : DrawnJob
{
    public LetteredJob(DrawnJob job, LetteredDrawing letters)
        : base(job) => Letters = letters;

    /// <summary>The texts that are cut, and their fonts.</summary>
    public LetteredDrawing Letters { get; init; }
}
