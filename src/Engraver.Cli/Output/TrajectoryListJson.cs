using Engraver.Workbench.Documents;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver trajectory --json</c> prints; names, units and meanings are the runner's contract.</summary>
internal sealed record TrajectoryListJson(IReadOnlyList<TrajectoryListJson.OneJson> Trajectories)
{
    public static TrajectoryListJson From(TrajectoryDrawing drawing) => new([.. drawing.Trajectories.Select(one => new OneJson(
        one.FileName, one.Source, one.File.Points, one.File.SampledError, one.File.VerifiedBound, one.File.SpacingRatio, one.File.Length, one.File.Closed, one.Seconds))]);

    public static void Text(TextWriter output, TrajectoryDrawing drawing)
    {
        foreach (var one in drawing.Trajectories)
            output.WriteLine(Wording.Get("Trajectory.File", one.FileName, one.File.Points, one.File.Length, one.File.VerifiedBound, one.File.SampledError, one.File.SpacingRatio));
    }

    /// <param name="MaxError">At samples, mm.</param>
    /// <param name="VerifiedBound">Proven, mm.</param>
    internal sealed record OneJson(string File, string? Source, int Points, double MaxError, double VerifiedBound, double MaxSpacingRatio, double Length, bool Closed, double Seconds);
}
