using Engraver.Core.Diagnostics;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Commands.Sequencing;

/// <summary>AUTOSEQUENCE: Chains and orders the drawing, nearest stroke first or optimally, reports contours, order and travel, and animates them.</summary>
internal sealed class AutoSequenceCommand : ICommand
{
    public CommandInfo Info { get; } = new("AUTOSEQUENCE", CommandGroup.Sequence);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var state = context.Document.Current;
        var settings = state.Settings.Order == StrokeOrder.Drawn ? state.Settings with { Order = StrokeOrder.Nearest } : state.Settings;
        var run = new StageRun(new DrawnJob(drawing, settings), cancellation);
        var ordered = run.To<OrderedJob>();
        var result = ordered.Sequence;
        FindingMessages.Write(context, drawing.FileName, [.. result.Diagnostics, .. ordered.Cut.FindingsBeside(result)], Severity.Warning);
        context.WriteResult(output => SequenceText.Write(output, result));
        context.Commit(state with { Settings = settings });
        var asks = context.Settings.Current.Variable(SystemVariables.AutoWalk) != 0.0;
        if (!asks && !context.IsInteractive) return;
        if (context.Derivation.IsAutomatic) await context.Derivation.ForCurrentAsync(cancellation).ConfigureAwait(false);
        await ContourAnimation.RunAsync(context, result, run.To<PathJob>().Toolpath, asks, cancellation).ConfigureAwait(false);
    }
}
