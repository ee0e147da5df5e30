using Engraver.Core.Sequencing;

namespace Engraver.Workbench.Stages;

/// <summary>A job in the order of cutting. It no longer holds the chained table, whose memory is released.</summary>
public record OrderedJob : CompensatedJob
{
    public OrderedJob(CompensatedJob job, SequencingResult sequence)
        : base(job) => Sequence = sequence;

    /// <summary>Strokes in order, discontinuities, the table in sequence order.</summary>
    public SequencingResult Sequence { get; init; }
}
