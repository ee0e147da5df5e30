using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACECONSTANTOFFSETS: Creates a series of trajectories at increasing offsets up to a maximum, as the plug-in does (sace-xps-agie.md 1.1).</summary>
/// <remarks>Offsets r, r + step, ... up to the largest; an offset between the largest minus r and the largest becomes the largest minus r, but at least r,
/// without duplicates.</remarks>
internal sealed class SaceConstantOffsetsCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACECONSTANTOFFSETS", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var contours = await SelectedContours.TakeAsync(context).ConfigureAwait(false);
        var radius = await TrajectoryPrompts.RemovalRadiusAsync(context).ConfigureAwait(false);
        var step = await TrajectoryPrompts.OffsetStepAsync(context).ConfigureAwait(false);
        var largest = await TrajectoryPrompts.LengthAsync(context, "SACE.largest", "Trajectories.MaximumOffset", 1.0).ConfigureAwait(false);
        if (largest < radius) throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.MaximumOffsetTooSmall", NumberPrompt.Format(largest), NumberPrompt.Format(radius)));
        if ((largest - radius) / step >= SaceOffsets.MaxPasses) throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.TooManyOffsets", SaceOffsets.MaxPasses));
        var side = await TrajectoryPrompts.SideAsync(context, contours).ConfigureAwait(false);
        SaceOffsets.Create(context, contours, Distances(radius, step, largest), side, SaceOffsets.NameOfPass, cancellation);
    }

    internal static IReadOnlyList<double> Distances(double radius, double step, double largest)
    {
        var (distances, near) = (new List<double>(), 1e-9 * largest);
        for (var pass = 0; radius + (pass * step) <= largest + near; pass++)
        {
            var distance = radius + (pass * step);
            if (distance > largest - radius + near && distance < largest - near) distance = Math.Max(radius, largest - radius);
            if (distances.Count == 0 || distance > distances[^1] + near) distances.Add(distance);
        }

        return distances;
    }
}
