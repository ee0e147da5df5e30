namespace Engraver.Core.Machines;

/// <summary>VM ... VE: segments that are cut without a stop. It begins at the present position of the machine.</summary>
/// <param name="Start">Where the sequence begins, job frame.</param>
/// <param name="Speed">VS for this sequence, even counts/s.</param>
/// <param name="Segments">At least one.</param>
public sealed record VectorSequence(CountsPoint Start, int Speed, IReadOnlyList<VectorSegment> Segments)
{
    /// <summary>Lines that rise or fall: the sequence is run in three axes (LM) instead of two (VM). It has no arcs.</summary>
    public bool ChangesHeight { get; init; }

    public CountsPoint End => Segments[^1].End;

    public double Length => Segments is SequenceSegments columns ? columns.Length : Segments.Sum(segment => segment.Length);
}
