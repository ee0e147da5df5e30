using Engraver.Core.Operations;

namespace Engraver.Workbench.Documents;

/// <summary>What one operation cuts in a job.</summary>
/// <param name="Feed">mm/min.</param>
/// <param name="Plunge">mm/min; null on a machine without a tool axis.</param>
/// <param name="Curves">Entities that it machines, points and inserts included.</param>
/// <param name="Strokes">Every pass is one.</param>
/// <param name="Passes">Passes of each stroke.</param>
/// <param name="Length">Of all strokes in plan, mm.</param>
/// <param name="Uncut">Places that its tool does not reach.</param>
public sealed record OperationSummary(Operation Operation, CuttingTool Tool, double Feed, double? Plunge, int Curves, int Strokes, int Passes, double Length, int Uncut)
{
    /// <summary>The operations that a job runs, in their order; empty for a job without operations.</summary>
    public static IReadOnlyList<OperationSummary> Of(PreparedJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return job.Settings.Operations is { } plan ? [.. job.Shapes.Select(shape => Of(job, plan, shape))] : [];
    }

    private static OperationSummary Of(PreparedJob job, OperationPlan plan, ShapedOperation shape)
    {
        var strokes = job.Sequence.Strokes.Zip(job.Passes).Where(pair => pair.Second.Operation.Id == shape.Operation.Id).Select(pair => pair.First).ToList();
        var curves = Enumerable.Range(0, shape.Part.Table.Count).Select(shape.Part.Table.EntityIndexOf).Distinct().Count() + shape.Part.Places.Count;
        return new OperationSummary(
            shape.Operation, shape.Part.Tool, plan.FeedOf(shape.Operation, job.Settings.Machine), plan.PlungeOf(shape.Operation, job.Settings.Machine), curves, strokes.Count,
            shape.Operation.PassDepths().Count, strokes.Sum(stroke => stroke.Length), shape.Uncut.Count);
    }
}
