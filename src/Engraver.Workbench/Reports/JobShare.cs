using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Workbench.Reports;

/// <summary>A part of a job: its strokes, times and cost.</summary>
/// <param name="Title">What it is, in words.</param>
/// <param name="Strokes">Number of its strokes.</param>
/// <param name="CutLength">Of all its strokes in plan, mm.</param>
/// <param name="Times">Planned times. The rapid to a stroke belongs to that stroke.</param>
/// <param name="Rates">Machining rates; null if undefined.</param>
public sealed record JobShare(string Title, int Strokes, double CutLength, MotionTimes Times, JobRates? Rates)
{
    /// <summary>Null without rates.</summary>
    public JobCost? Cost => Rates?.CostOf(Times.Total, CutLength, Strokes);

    /// <summary>Strokes, length, times and cost in one line.</summary>
    public string Text => Cost is { } cost
        ? Wording.Get("JobSheet.ShareWithCost", Strokes, CutLength / 1000.0, Times.Cutting, Times.Rapid + Times.Dwell, cost.Total)
        : Wording.Get("JobSheet.Share", Strokes, CutLength / 1000.0, Times.Cutting, Times.Rapid + Times.Dwell);
}
