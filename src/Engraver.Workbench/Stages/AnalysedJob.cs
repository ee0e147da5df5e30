using Engraver.Core.EntityTables;

namespace Engraver.Workbench.Stages;

/// <summary>A job with its table, arcs analysed.</summary>
public record AnalysedJob : LetteredJob
{
    public AnalysedJob(LetteredJob job, EntityTable analysed)
        : base(job) => Analysed = analysed;

    /// <summary>The fixed-slot table of the selected layers as drawn, file order, millimetres.</summary>
    public EntityTable Analysed { get; init; }
}
