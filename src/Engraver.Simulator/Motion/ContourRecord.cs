namespace Engraver.Simulator.Motion;

/// <summary>One CD: counts that each axis of CM moves within the given number of samples. 0 samples mark the end of the contour.</summary>
internal sealed record ContourRecord(int[] Increments, int Samples)
{
    public bool IsEnd => Samples == 0;
}
