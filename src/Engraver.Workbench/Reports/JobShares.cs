using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Operations;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Reports;

/// <summary>The times and the cost of a job by its operations and by its tools. The sum of the operations and of <see cref="Around"/> is the job, and so is
/// that of the tools and of <see cref="Around"/>.</summary>
/// <param name="Operations">In the order of the job.</param>
/// <param name="Tools">Each tool once, in the order of its first operation.</param>
/// <param name="Around">What belongs to no operation (<see cref="StrokeTimes.Around"/>).</param>
public sealed record JobShares(IReadOnlyList<(Operation Operation, JobShare Share)> Operations, IReadOnlyList<(CuttingTool Tool, IReadOnlyList<Operation> Operations, JobShare Share)> Tools, JobShare Around)
{
    /// <summary>All parts, for lists.</summary>
    public IEnumerable<JobShare> All => [.. Operations.Select(one => one.Share), .. Tools.Select(one => one.Share), Around];

    /// <param name="program">Of the job, whole.</param>
    /// <param name="times">Of the program.</param>
    /// <returns>Null for a job without operations.</returns>
    public static JobShares? Of(PreparedJob job, MotionProgram program, StrokeTimes times, JobRates? rates)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(times);
        if (job.Settings.Operations is null) return null;
        var byOperation = program.Strokes.Zip(times.Strokes).ToLookup(pair => job.Passes[pair.First.Index].Operation.Id, pair => pair.Second);
        var summaries = OperationSummary.Of(job);
        return new JobShares(
            [.. summaries.Select(one => (one.Operation, Share(Wording.Get("JobReport.Operation", one.Operation.Title), [one])))],
            [.. summaries.GroupBy(one => one.Tool.Number).Select(own => (own.First().Tool, (IReadOnlyList<Operation>)[.. own.Select(one => one.Operation)], Share(Wording.Get("JobSheet.Tool", own.First().Tool.Title), [.. own])))],
            new JobShare(Wording.Get("JobSheet.Around"), 0, 0.0, times.Around, rates));

        JobShare Share(string title, IReadOnlyList<OperationSummary> parts) =>
            new(title, parts.Sum(one => one.Strokes), parts.Sum(one => one.Length), parts.SelectMany(one => byOperation[one.Operation.Id]).Aggregate(default(MotionTimes), (sum, one) => sum + one), rates);
    }
}
