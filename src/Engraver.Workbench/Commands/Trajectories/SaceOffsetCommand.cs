namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACEOFFSET: Creates trajectories at an offset of the removal radius of the tool from objects (paper 004, section 2.2).</summary>
internal sealed class SaceOffsetCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACEOFFSET", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var contours = await SelectedContours.TakeAsync(context).ConfigureAwait(false);
        var radius = await TrajectoryPrompts.RemovalRadiusAsync(context).ConfigureAwait(false);
        var side = await TrajectoryPrompts.SideAsync(context, contours).ConfigureAwait(false);
        SaceOffsets.Create(context, contours, [radius], side, (_, loop) => number => $"traj{number}_offset-{loop}", cancellation);
    }
}
