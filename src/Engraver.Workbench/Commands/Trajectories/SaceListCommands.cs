using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACESHOWTRAJECTORIES: Lists the trajectories: name, points, length, proven error, ratio of steps, height.</summary>
internal sealed class SaceShowTrajectoriesCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACESHOWTRAJECTORIES", CommandGroup.Trajectory) { Transparent = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var list = context.Document.Current.Sidecar.Trajectories;
        var (now, edits) = (list.Settings, context.Document.Current.Drawing is { } drawing ? new TrajectoryEdits(drawing) : null);
        context.SayResult(output =>
        {
            foreach (var one in list.All) output.WriteLine(edits?.IsStale(one) == true ? Wording.Get("Trajectories.Edited", TrajectoryLine.Format(one)) : TrajectoryLine.Format(one));
            output.WriteLine(Wording.Get("Trajectories.Count", CountText.Format(list.All.Count, "Trajectory")));
            output.WriteLine(now.DynamicDensity ? Wording.Get("Trajectories.Dynamic", NumberPrompt.Show(now.MaxErrorMm)) : Wording.Get("Trajectories.Uniform", NumberPrompt.Show(now.SegmentLengthMm)));
        });
        return Task.CompletedTask;
    }
}

/// <summary>SACEDELETELASTTRAJECTORY: Removes the last trajectory from the list.</summary>
internal sealed class SaceDeleteLastTrajectoryCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACEDELETELASTTRAJECTORY", CommandGroup.Trajectory);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var all = TrajectoryPick.All(context);
        TrajectoryChange.All(context, [.. all.SkipLast(1)]);
        context.Say(Wording.Get("Trajectories.Deleted", all[^1].Name));
        return Task.CompletedTask;
    }
}

/// <summary>SACEDELETEALLTRAJECTORIES: Empties the list; UNDO brings it back.</summary>
internal sealed class SaceDeleteAllTrajectoriesCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACEDELETEALLTRAJECTORIES", CommandGroup.Trajectory);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var all = TrajectoryPick.All(context);
        TrajectoryChange.All(context, []);
        context.Say(Wording.Get("Trajectories.Deleted", CountText.Format(all.Count, "Trajectory")));
        return Task.CompletedTask;
    }
}

/// <summary>Trajectories by name.</summary>
internal static class TrajectoryPick
{
    /// <exception cref="CommandException">There is none.</exception>
    public static IReadOnlyList<DocumentTrajectory> All(CommandContext context) =>
        context.Document.Current.Sidecar.Trajectories.All is { Count: > 0 } all ? all : throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.None"));

    /// <exception cref="CommandException">None has that name.</exception>
    public static async Task<int> OneAsync(CommandContext context)
    {
        var all = All(context);
        var name = await context.ValueAsync(new TextPrompt(Wording.Get("Trajectories.EnterName")) { Default = all[^1].Name }).ConfigureAwait(false);
        return context.Document.Current.Sidecar.Trajectories.IndexOf(name) is >= 0 and var found ? found : throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.NotFound", name));
    }
}
