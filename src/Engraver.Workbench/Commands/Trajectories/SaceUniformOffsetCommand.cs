using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACEUNIFORMOFFSET: Creates a series of trajectories at decreasing offsets, the last at the removal radius of the tool (paper 004, section 2.2:
/// offset step, number of passes, direction).</summary>
internal sealed class SaceUniformOffsetCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACEUNIFORMOFFSET", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var contours = await SelectedContours.TakeAsync(context).ConfigureAwait(false);
        var radius = await TrajectoryPrompts.RemovalRadiusAsync(context).ConfigureAwait(false);
        var step = await TrajectoryPrompts.OffsetStepAsync(context).ConfigureAwait(false);
        var passes = (int)await context.ValueAsync(new NumberPrompt(Wording.Get("Trajectories.Passes")) { Default = "3", Min = 1, Max = SaceOffsets.MaxPasses, IsInteger = true }).ConfigureAwait(false);
        var side = await TrajectoryPrompts.SideAsync(context, contours).ConfigureAwait(false);
        SaceOffsets.Create(context, contours, [.. Enumerable.Range(0, passes).Select(pass => radius + ((passes - 1 - pass) * step))], side, SaceOffsets.NameOfPass, cancellation);
    }
}
