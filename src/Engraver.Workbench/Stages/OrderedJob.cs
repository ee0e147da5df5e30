using Engraver.Core.Operations;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Workbench.Stages;

/// <summary>A job in the order of cutting. It no longer holds the chained table, whose memory is released.</summary>
public record OrderedJob : ShapedJob
{
    public OrderedJob(ShapedJob job, SequencingResult sequence)
        : base(job) => Sequence = sequence;

    /// <summary>Strokes in order, discontinuities, the table in sequence order.</summary>
    public SequencingResult Sequence { get; init; }

    /// <summary>The strokes of the operations before they have passes; empty for a job without operations.</summary>
    public IReadOnlyList<OrderedOperation> Operations { get; init; } = [];

    /// <summary>The chained drawing until the operations have their passes; null otherwise.</summary>
    public ChainedTable? Drawn { get; init; }

    /// <summary>Operation and pass of each stroke; empty for a job without operations.</summary>
    public IReadOnlyList<StrokePass> Passes { get; init; } = [];

    /// <summary>Tabs and starts of the operations that have any.</summary>
    public IReadOnlyList<DressedPlaces> Places { get; init; } = [];
}
