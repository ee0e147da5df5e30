namespace Engraver.Galil.Programs;

/// <summary>VM ... VE: a run of segments cut without a stop. Its first point is where the machine stands when it begins.</summary>
/// <param name="Start">Where the sequence begins, job frame.</param>
/// <param name="Speed">VS for this sequence, even counts/s.</param>
/// <param name="Segments">At least one.</param>
public sealed record VectorSequence(CountsPoint Start, int Speed, IReadOnlyList<VectorSegment> Segments)
{
    public CountsPoint End => Segments[^1].End;

    public double Length => Segments.Sum(segment => segment.Length);
}
