using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Compares the positions that the machine reported with the drawing, in both directions, and never with the planned path.</summary>
public static class TraceComparison
{
    /// <summary>Determines the largest distance of a cutting sample from the drawing, and the length of the drawing that no cut came near.</summary>
    /// <param name="drawing">The drawing to cut, millimetres; order and direction are irrelevant. Ellipses and splines are exact, not the arcs that were cut
    /// for them.</param>
    /// <param name="trace">Samples in order of time.</param>
    /// <param name="tolerances">Tolerances that define what counts as cut and which gaps are ignored.</param>
    public static TraceVerdict Compare(IReadOnlyList<Segment> drawing, IReadOnlyList<TraceSample> trace, TraceTolerances tolerances)
    {
        var judge = new TraceJudge(drawing, tolerances);
        foreach (var sample in trace) judge.Add(sample);
        return judge.Verdict();
    }
}
