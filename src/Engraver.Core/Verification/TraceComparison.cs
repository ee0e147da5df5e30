using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Compares the positions that the machine reported with the drawing, in both directions, and never with our own plan.</summary>
public static class TraceComparison
{
    /// <summary>Largest distance of a cutting sample from the drawing, and the length of the drawing that no cut came near.</summary>
    /// <param name="drawing">What was to be cut, millimetres; order and direction do not matter. Ellipses and splines are exact here, not the arcs that were cut for them.</param>
    /// <param name="trace">In order of time.</param>
    /// <param name="tolerances">What counts as cut, and which gaps do not count.</param>
    public static TraceVerdict Compare(IReadOnlyList<Segment> drawing, IReadOnlyList<TraceSample> trace, TraceTolerances tolerances)
    {
        var judge = new TraceJudge(drawing, tolerances);
        foreach (var sample in trace) judge.Add(sample);
        return judge.Verdict();
    }
}
