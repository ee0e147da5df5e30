using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACEDELETEALLTRAJECTORIES: Empties the list; UNDO brings it back.</summary>
internal sealed class SaceDeleteAllTrajectoriesCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACEDELETEALLTRAJECTORIES", CommandGroup.Trajectory);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var all = TrajectorySelection.All(context);
        TrajectoryChange.All(context, []);
        context.WriteMessage(Wording.Get("Trajectories.Deleted", CountText.Format(all.Count, "Trajectory")));
        return Task.CompletedTask;
    }
}
