using Engraver.Core.Trajectories;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACEHELICALDRILL: Bores a hole by a helix from the machining plane down, with one full turn at the bottom ("helical boring", paper 004, section 5;
/// the plug-in's command was empty).</summary>
internal sealed class SaceHelicalDrillCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACEHELICALDRILL", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var centre = await context.ValueAsync(new PointPrompt(Wording.Get("Trajectories.HoleCentre"))).ConfigureAwait(false);
        var hole = await TrajectoryPrompts.LengthAsync(context, "SACEHELICALDRILL.hole", "Trajectories.HoleRadius", 1.0, centre).ConfigureAwait(false);
        var tool = await TrajectoryPrompts.RemovalRadiusAsync(context).ConfigureAwait(false);
        if (!(hole > tool)) throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.HoleTooSmall", NumberPrompt.Format(hole), NumberPrompt.Format(tool)));
        var depth = await TrajectoryPrompts.LengthAsync(context, "SACEHELICALDRILL.depth", "Trajectories.FinalDepth", 1.0).ConfigureAwait(false);
        var pitch = await TrajectoryPrompts.LengthAsync(context, "SACEHELICALDRILL.pitch", "Trajectories.Pitch", 0.1).ConfigureAwait(false);
        var sense = await context.ChoiceAsync(Wording.Get("Trajectories.Sense"), Keyword.List("Clockwise", "cOunterclockwise"), "cOunterclockwise").ConfigureAwait(false);
        var making = new TrajectoryBuilder(context, cancellation);
        var scale = making.Scale;
        var helix = HelixPlanner.Plan(scale.ToMillimetres(centre), scale.ToMillimetres(hole - tool), making.Settings.PlaneZ, scale.ToMillimetres(depth), scale.ToMillimetres(pitch), sense == "Clockwise", making.Settings.MaxErrorMm)
            ?? throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.TooManyTurns", HelixPlanner.MaxTurns));
        making.Add(helix, [], number => $"traj{number}_drill");
        making.Commit();
    }
}
