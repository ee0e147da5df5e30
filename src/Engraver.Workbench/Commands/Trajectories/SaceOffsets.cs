using Engraver.Core.Offsets;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>Shared by the offset commands.</summary>
internal static class SaceOffsets
{
    public const int MaxPasses = 10_000;

    public static Func<int, string> NameOfPass(int pass, int loop) => number => $"traj{number}_offset{pass}-{loop}";

    /// <summary>Every pass is an offset of the objects themselves, never of another pass.</summary>
    /// <param name="distances">Drawing units, in the order in which they are made.</param>
    /// <param name="name">From the pass and the loop in it.</param>
    public static void Create(CommandContext context, SelectedContours contours, IReadOnlyList<double> distances, Func<SelectedContour, OffsetSide> side, Func<int, int, Func<int, string>> name, CancellationToken cancellation)
    {
        var making = new TrajectoryBuilder(context, cancellation);
        var groups = contours.All.GroupBy(side).ToList();
        for (var pass = 0; pass < distances.Count; pass++)
        {
            var loop = 0;
            foreach (var group in groups)
            {
                var (sources, distance) = (group.ToList(), making.Scale.ToMillimetres(distances[pass]));
                var result = ContourOffset.Offset([.. sources.Select(one => one.Contour)], distance, group.Key, OffsetOptions.Round(making.Settings.MaxErrorMm));
                making.AddFindings(OffsetDrawing.Findings(result, sources.Count, distance));
                (OffsetContour, Func<int, string>)[] loops = [.. result.Loops.Select(one => (new OffsetContour(one.Segments, one.Closed), name(pass, loop++)))];
                making.AddOffsets(loops, [.. sources.SelectMany(one => one.Handles).Distinct()], distance, group.Key);
            }
        }

        making.Commit();
    }
}
