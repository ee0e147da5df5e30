using Engraver.Core.Trajectories;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACECORNERS: Selects the treatment of corners: the end of a trajectory, or a rounding within the error.</summary>
internal sealed class SaceCornersCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACECORNERS", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var now = context.Document.Current.Sidecar.Trajectories.Settings.Corners;
        var chosen = await context.ChoiceAsync(Wording.Get("Trajectories.Corners"), Keyword.List(Enum.GetNames<CornerMode>()), now.ToString()).ConfigureAwait(false);
        TrajectoryChange.Settings(context, settings => settings with { Corners = Enum.Parse<CornerMode>(chosen) });
    }
}
