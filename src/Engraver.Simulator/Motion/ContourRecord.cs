namespace Engraver.Simulator.Motion;

/// <summary>One CD: how far each axis of CM goes within so many samples. No samples is the end of the contour.</summary>
internal sealed record ContourRecord(int[] Increments, int Samples)
{
    public bool IsEnd => Samples == 0;
}
