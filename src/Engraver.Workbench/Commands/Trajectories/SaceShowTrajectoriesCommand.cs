using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACESHOWTRAJECTORIES: Lists the trajectories: name, points, length, proven error, ratio of steps, height.</summary>
internal sealed class SaceShowTrajectoriesCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACESHOWTRAJECTORIES", CommandGroup.Trajectory) { IsTransparent = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var list = context.Document.Current.Sidecar.Trajectories;
        var (now, edits) = (list.Settings, context.Document.Current.Drawing is { } drawing ? new TrajectoryEdits(drawing) : null);
        context.WriteResult(output =>
        {
            foreach (var one in list.All) output.WriteLine(edits?.IsStale(one) == true ? Wording.Get("Trajectories.Edited", TrajectoryLine.Format(one)) : TrajectoryLine.Format(one));
            output.WriteLine(Wording.Get("Trajectories.Count", CountText.Format(list.All.Count, "Trajectory")));
            output.WriteLine(now.DynamicDensity ? Wording.Get("Trajectories.Dynamic", NumberPrompt.Format(now.MaxErrorMm)) : Wording.Get("Trajectories.Uniform", NumberPrompt.Format(now.SegmentLengthMm)));
        });
        return Task.CompletedTask;
    }
}
