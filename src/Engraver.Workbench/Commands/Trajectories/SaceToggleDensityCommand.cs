using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACETOGGLEDYNAMICDENSITY: Switches between curvature-dependent points and equal steps.</summary>
internal sealed class SaceToggleDensityCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACETOGGLEDYNAMICDENSITY", CommandGroup.Trajectory);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        TrajectoryChange.Settings(context, settings => settings with { DynamicDensity = !settings.DynamicDensity });
        var now = context.Document.Current.Sidecar.Trajectories.Settings;
        context.WriteMessage(now.DynamicDensity ? Wording.Get("Trajectories.Dynamic", NumberPrompt.Format(now.MaxErrorMm)) : Wording.Get("Trajectories.Uniform", NumberPrompt.Format(now.SegmentLengthMm)));
        return Task.CompletedTask;
    }
}
