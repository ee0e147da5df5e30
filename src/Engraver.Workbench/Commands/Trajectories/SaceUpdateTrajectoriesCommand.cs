using Engraver.Core.Diagnostics;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACEUPDATETRAJECTORIES: Recomputes the trajectories whose objects have been edited; names, heights, errors and positions in the list are
/// kept.</summary>
internal sealed class SaceUpdateTrajectoriesCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACEUPDATETRAJECTORIES", CommandGroup.Trajectory);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        List<DocumentTrajectory> all = [.. TrajectorySelection.All(context)];
        var edits = new TrajectoryEdits(context.Drawing);
        var remaking = new TrajectoryUpdate(context.Drawing, context.Document.Current, edits);
        var groups = all.Where(edits.IsStale).GroupBy(one => one.Origin!.Group).Select(group => group.ToList()).ToList();
        if (groups.Count == 0)
        {
            context.WriteMessage(Wording.Get("Trajectories.NoneEdited"));
            return Task.CompletedTask;
        }

        var made = new List<DocumentTrajectory>();
        foreach (var group in groups)
        {
            cancellation.ThrowIfCancellationRequested();
            if (remaking.Rebuild(group) is { Count: > 0 } anew)
            {
                all.InsertRange(all.IndexOf(group[0]), anew);
                all.RemoveAll(group.ToHashSet<object>(ReferenceEqualityComparer.Instance).Contains);
                made.AddRange(anew);
            }
            else
            {
                context.WriteMessage(Wording.Get("Trajectories.SourceGone", string.Join(", ", group.Select(one => one.Name))), MessageKind.Warning);
            }
        }

        FindingMessages.Write(context, context.Drawing.FileName, remaking.Findings, Severity.Warning);
        if (made.Count == 0) throw new CommandException(CommandFailure.Drawing, Wording.Get("Trajectories.NoneMade"));
        foreach (var one in made) context.WriteMessage(TrajectoryLine.Format(one), MessageKind.Result);
        TrajectoryChange.All(context, all, remaking.NextNumber);
        return Task.CompletedTask;
    }
}
