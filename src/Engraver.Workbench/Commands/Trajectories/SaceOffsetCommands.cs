using Engraver.Core.Offsets;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

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
        SaceOffsets.Make(context, contours, [radius], side, (_, loop) => number => $"traj{number}_offset-{loop}", cancellation);
    }
}

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
        var passes = (int)await context.ValueAsync(new NumberPrompt(Wording.Get("Trajectories.Passes")) { Default = "3", Least = 1, Most = SaceOffsets.MostPasses, Whole = true }).ConfigureAwait(false);
        var side = await TrajectoryPrompts.SideAsync(context, contours).ConfigureAwait(false);
        SaceOffsets.Make(context, contours, [.. Enumerable.Range(0, passes).Select(pass => radius + ((passes - 1 - pass) * step))], side, SaceOffsets.NameOfPass, cancellation);
    }
}

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
        if (largest < radius) throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.MaximumOffsetTooSmall", NumberPrompt.Show(largest), NumberPrompt.Show(radius)));
        if ((largest - radius) / step >= SaceOffsets.MostPasses) throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.TooManyOffsets", SaceOffsets.MostPasses));
        var side = await TrajectoryPrompts.SideAsync(context, contours).ConfigureAwait(false);
        SaceOffsets.Make(context, contours, Distances(radius, step, largest), side, SaceOffsets.NameOfPass, cancellation);
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

/// <summary>Shared by the offset commands.</summary>
internal static class SaceOffsets
{
    public const int MostPasses = 10_000;

    public static Func<int, string> NameOfPass(int pass, int loop) => number => $"traj{number}_offset{pass}-{loop}";

    /// <summary>Every pass is an offset of the objects themselves, never of another pass.</summary>
    /// <param name="distances">Drawing units, in the order in which they are made.</param>
    /// <param name="name">From the pass and the loop in it.</param>
    public static void Make(CommandContext context, SelectedContours contours, IReadOnlyList<double> distances, Func<SelectedContour, OffsetSide> side, Func<int, int, Func<int, string>> name, CancellationToken cancellation)
    {
        var making = new TrajectoryMaking(context, cancellation);
        var groups = contours.All.GroupBy(side).ToList();
        for (var pass = 0; pass < distances.Count; pass++)
        {
            var loop = 0;
            foreach (var group in groups)
            {
                var (sources, distance) = (group.ToList(), making.Scale.ToMillimetres(distances[pass]));
                var result = ContourOffset.Offset([.. sources.Select(one => one.Contour)], distance, group.Key, OffsetOptions.Round(making.Settings.MaxErrorMm));
                making.Tell(OffsetDrawing.Findings(result, sources.Count, distance));
                (OffsetContour, Func<int, string>)[] loops = [.. result.Loops.Select(one => (new OffsetContour(one.Segments, one.Closed), name(pass, loop++)))];
                making.AddBeside(loops, [.. sources.SelectMany(one => one.Handles).Distinct()], distance, group.Key);
            }
        }

        making.Take();
    }
}
