using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.Core.Toolpaths;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Plans the moves from the start point of the tool; ellipses and splines become arcs.</summary>
internal sealed class PathStage() : JobStage<OrderedJob, PathJob>("Path", share: 10)
{
    public override IReadOnlyList<Setting> Settings => [SettingTable.Start, SettingTable.MaxError, SettingTable.Operations, SettingTable.Machine, SettingTable.Feed, SettingTable.VectorSpeed];

    public override bool IsMeasured => false; // The lines of the measured drawing are moves already.

    /// <summary>The path of lines and arcs from the start point of the tool.</summary>
    public static Toolpath ToolpathOf(OrderedJob job)
    {
        var path = ToolpathPlanner.Plan(job.Sequence, job.Settings.Start, job.Settings.MaxErrorMm);
        if (job.Settings.Operations is not { } plan || job.Passes.Count == 0) return path;
        return path with { Strokes = [.. path.Strokes.Zip(job.Passes, (stroke, pass) => WithTerms(stroke, pass.Operation, plan, job.Settings))] };
    }

    private static ToolpathStroke WithTerms(ToolpathStroke stroke, Operation operation, OperationPlan plan, DrawingSettings settings) => stroke with
    {
        FeedMmPerMinute = plan.FeedOf(operation, settings.Machine),
        PlungeMmPerMinute = plan.PlungeOf(operation, settings.Machine),
        PierceSeconds = operation.PierceSeconds,
        DwellSeconds = operation.DwellSeconds,
        Outputs = OperationPlan.OutputsOf(operation, settings.Machine),
        AnalogPart = plan.AnalogPartOf(operation, settings.Machine, settings.Tool),
    };

    protected override PathJob Execute(OrderedJob job, CancellationToken cancellation) => new(job, ToolpathOf(job));
}
