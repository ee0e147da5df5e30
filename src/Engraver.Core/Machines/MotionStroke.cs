namespace Engraver.Core.Machines;

/// <summary>One stroke: rapid to <see cref="Start"/> with the tool off, tool on, every sequence in order (at rest between two of them), tool off. Where an axis
/// is the tool drive, "on" is at the height of the start and "off" at clearance height; each pass is a stroke with the same index.</summary>
public sealed record MotionStroke(int Index, CountsPoint Start, IReadOnlyList<VectorSequence> Sequences)
{
    /// <summary>How its operation brings the tool to the work and takes it away; null: as the profile states.</summary>
    public StrokeTerms? Terms { get; init; }

    public int SegmentCount => Sequences is StrokeSequences columns ? columns.SegmentCount : Sequences.Sum(sequence => sequence.Segments.Count);
}
