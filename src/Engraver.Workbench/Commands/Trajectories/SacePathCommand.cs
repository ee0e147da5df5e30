namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACEPATH: Creates trajectories that follow objects (paper 004, section 2.2; sace-xps-agie.md 1.1).</summary>
internal sealed class SacePathCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACEPATH", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var contours = await SelectedContours.TakeAsync(context).ConfigureAwait(false);
        var making = new TrajectoryBuilder(context, cancellation);
        foreach (var one in contours.All) making.Add(one, number => $"traj{number}_path", making.Settings.PlaneZ);
        making.Commit();
    }
}
