using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Pockets;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Benchmarks.Pockets;

/// <summary>Processor time of a square pocket of 100 mm with 20 round islands, for several tools: the number of passes is proportional to the reciprocal of
/// the stepover.</summary>
internal static class PocketBenchmark
{
    /// <summary>Head of the table, Markdown.</summary>
    public static string Head => "| strategy | R mm | F | passes | pass length m | strokes | coverage | CPU s |\n|---|---|---|---|---|---|---|---|";

    /// <summary>The rows, in order.</summary>
    public static IEnumerable<string> Rows(CancellationToken stop)
    {
        var contours = Contours();
        Measure(contours, OptionsOf(2.0, 0.5, PocketStrategy.Contour)); // compiles what is measured
        foreach (var strategy in (PocketStrategy[])[PocketStrategy.Contour, PocketStrategy.Zigzag])
        {
            foreach (var (radius, stepover) in ((double, double)[])[(1.0, 0.5), (0.5, 0.5), (0.5, 0.9), (0.25, 0.5)])
            {
                stop.ThrowIfCancellationRequested();
                yield return Measure(contours, OptionsOf(radius, stepover, strategy));
            }
        }
    }

    private static PocketOptions OptionsOf(double radius, double stepover, PocketStrategy strategy) => new()
    {
        ToolRadius = radius, Stepover = stepover, Strategy = strategy,
        Angle = Angle.FromDegrees(PocketDefaults.AngleDegrees), FromCentre = PocketDefaults.FromCentre, Allowance = PocketDefaults.Allowance,
        MaxErrorMm = DrawingSettings.Default.MaxErrorMm, JoinToleranceMm = DrawingSettings.Default.JoinToleranceMm,
    };

    private static string Measure(IReadOnlyList<OffsetContour> contours, PocketOptions options)
    {
        var before = Environment.CpuUsage.TotalTime;
        var pocket = PocketPlanner.Plan(contours, options);
        var seconds = (Environment.CpuUsage.TotalTime - before).TotalSeconds;
        var metres = pocket.Passes.Sum(pass => pass.Segments.Sum(segment => segment.Length)) / 1000.0;
        return string.Create(CultureInfo.InvariantCulture, $"| {options.Strategy} | {options.ToolRadius} | {options.Stepover} | {pocket.Passes.Count} | {metres:0.##} | {pocket.Strokes.Count} | {100.0 * pocket.Coverage:0.#####} % | {seconds:0.###} |");
    }

    private static List<OffsetContour> Contours()
    {
        Point2D[] corners = [new(0, 0), new(100, 0), new(100, 100), new(0, 100)];
        var random = new Random(1);
        List<OffsetContour> contours = [new([.. corners.Select((corner, i) => Segment.FromLine(corner, corners[(i + 1) % 4]))], true)];
        for (var i = 0; i < 20; i++)
        {
            var centre = new Point2D(12.0 + (i % 5 * 19.0) + random.NextDouble(), 12.0 + (i / 5 * 25.0) + random.NextDouble());
            contours.Add(new OffsetContour([Segment.FromArc(new ArcSegment(centre, 2.0 + (4.0 * random.NextDouble()), Angle.Zero, Angle.FullTurn))], true));
        }

        return contours;
    }
}
