namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACEDEEPENGRAVING: Repeats the trajectories of objects at increasing depths: at 0, one step, two steps ... and at the final depth below the
/// machining plane.</summary>
/// <remarks>The plug-in of 2022 omitted the final depth if it was not a multiple of the step (sace-xps-agie.md 1.1); here it is always included.</remarks>
internal sealed class SaceDeepEngravingCommand : ICommand
{
    private const int MaxDepths = 10_000;

    public CommandInfo Info { get; } = new("SACEDEEPENGRAVING", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var contours = await SelectedContours.TakeAsync(context).ConfigureAwait(false);
        var step = await TrajectoryPrompts.LengthAsync(context, "SACEDEEPENGRAVING.step", "Trajectories.DepthStep", 0.1).ConfigureAwait(false);
        var depth = await TrajectoryPrompts.LengthAsync(context, "SACEDEEPENGRAVING.depth", "Trajectories.FinalDepth", 1.0).ConfigureAwait(false);
        if (depth / step > MaxDepths) throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.TooManyDepths", MaxDepths));
        var making = new TrajectoryBuilder(context, cancellation);
        var count = (int)Math.Ceiling((depth / step) - 1e-9);
        double[] heights = [.. Enumerable.Range(0, count + 1).Select(i => making.Settings.PlaneZ - making.Scale.ToMillimetres(Math.Min(depth, i * step)))];
        foreach (var one in contours.All) making.Add(one, number => $"traj{number}_deep", heights);
        making.Commit();
    }
}
