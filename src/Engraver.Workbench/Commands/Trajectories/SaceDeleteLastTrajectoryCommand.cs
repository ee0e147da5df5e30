namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACEDELETELASTTRAJECTORY: Removes the last trajectory from the list.</summary>
internal sealed class SaceDeleteLastTrajectoryCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACEDELETELASTTRAJECTORY", CommandGroup.Trajectory);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var all = TrajectorySelection.All(context);
        TrajectoryChange.All(context, [.. all.SkipLast(1)]);
        context.WriteMessage(Wording.Get("Trajectories.Deleted", all[^1].Name));
        return Task.CompletedTask;
    }
}
