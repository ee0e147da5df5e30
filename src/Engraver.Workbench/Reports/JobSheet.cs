using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Reports;

/// <summary>Summary of a job: lengths, times, cost. Used by the console, the job palette and the report.</summary>
/// <param name="CutLength">Cut length of the drawing, mm.</param>
/// <param name="Travel">Between strokes, mm.</param>
/// <param name="Starts">Number of strokes.</param>
/// <param name="Times">Planned times.</param>
/// <param name="Rates">Machining rates; null if undefined.</param>
public sealed record JobSheet(string Drawing, double CutLength, double Travel, int Starts, MotionTimes Times, JobRates? Rates)
{
    /// <summary>The parts of the job; null without operations.</summary>
    public JobShares? Shares { get; init; }

    /// <summary>Null without rates.</summary>
    public JobCost? Cost => Rates?.CostOf(Times.Total, CutLength, Starts);

    /// <param name="times">Times over its link.</param>
    public static JobSheet Of(PreparedJob job, MotionTimes times, JobRates? rates)
    {
        ArgumentNullException.ThrowIfNull(job);
        return new JobSheet(Path.GetFileName(job.Drawing.FileName), job.Sequence.PathLength, job.Sequence.Travel, job.Sequence.Strokes.Count, times, rates);
    }

    /// <param name="program">As it is run over its link.</param>
    /// <param name="times">Times of the program over its link.</param>
    public static JobSheet Of(PreparedJob job, MotionProgram program, StrokeTimes times, JobRates? rates)
    {
        ArgumentNullException.ThrowIfNull(times);
        return Of(job, times.Total, rates) with { Shares = JobShares.Of(job, program, times, rates) };
    }

    /// <summary>The lines of the sheet: name and value.</summary>
    public IReadOnlyList<(string What, string HowMuch)> Lines =>
    [
        (Wording.Get("JobSheet.Drawing"), Drawing),
        (Wording.Get("JobSheet.CutLength"), Wording.Get("JobSheet.Metres", CutLength / 1000.0)),
        (Wording.Get("JobSheet.Travel"), Wording.Get("JobSheet.Metres", Travel / 1000.0)),
        (Wording.Get("JobSheet.Starts"), Wording.Get("JobSheet.Number", Starts)),
        (Wording.Get("JobSheet.Cutting"), Wording.Get("JobSheet.Seconds", Times.Cutting)),
        (Wording.Get("JobSheet.Rapid"), Wording.Get("JobSheet.Seconds", Times.Rapid)),
        (Wording.Get("JobSheet.Dwell"), Wording.Get("JobSheet.Seconds", Times.Dwell)),
        (Wording.Get("JobSheet.Time"), Wording.Get("JobSheet.Seconds", Times.Total)),
        .. Rates is { } rates && Cost is { } cost
            ? (IEnumerable<(string, string)>)
            [
                (Wording.Get("JobSheet.ForTime"), Wording.Get("JobSheet.PerHour", cost.Time, rates.PerHour)),
                (Wording.Get("JobSheet.ForLength"), Wording.Get("JobSheet.PerMetre", cost.Length, rates.PerMetre)),
                (Wording.Get("JobSheet.ForStarts"), Wording.Get("JobSheet.PerStart", cost.Starts, rates.PerStart)),
                (Wording.Get("JobSheet.Cost"), Wording.Get("JobSheet.Money", cost.Total)),
            ]
            : [],
        .. Shares is { } shares ? shares.All.Select(share => (share.Title, share.Text)) : [],
    ];

    /// <summary>The sheet as text, with names and values in two columns.</summary>
    public void Write(TextWriter output)
    {
        ArgumentNullException.ThrowIfNull(output);
        var width = Lines.Max(line => line.What.Length) + 2;
        foreach (var (what, howMuch) in Lines) output.WriteLine(what.PadRight(width) + howMuch);
    }
}
