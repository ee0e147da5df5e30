using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Workbench.Stages;

/// <summary>A job whose entities are joined to contours.</summary>
public record ChainedJob : ShapedJob
{
    public ChainedJob(ShapedJob job, ChainedTable chained)
        : base(job) => Chained = chained;

    public ChainedTable Chained { get; init; }
}
