using System.Globalization;
using Engraver.Core.Offsets;
using Engraver.Workbench.Settings;

namespace Engraver.Benchmarks.Offsets;

/// <summary>Processor time of offsets by 1 mm, and its growth with the number of vertices.</summary>
internal static class OffsetBenchmark
{
    private const double Distance = 1.0;

    /// <summary>Number of runs for the median; more if one run is too short for a clock of milliseconds.</summary>
    private const int Runs = 5;

    private const int MoreRuns = 31;

    private const int ShortRun = 50_000;

    /// <summary>With fewer vertices the time is too short to be measured.</summary>
    private const int NoRun = 5_000;

    /// <summary>The two lines above the rows.</summary>
    public const string Head = "| Contour | side | vertices | CPU ms (median) | times that of the row before | loops | open | unresolved | deviation mm |\n|---|---|---:|---:|---:|---:|---:|---:|---:|";

    /// <summary>A row for each contour, side and number of vertices.</summary>
    /// <param name="sizes">Numbers of vertices, growing.</param>
    /// <param name="stop">Checked between two runs.</param>
    public static IEnumerable<string> Rows(IReadOnlyList<int> sizes, CancellationToken stop)
    {
        foreach (var (name, create) in OffsetContours.All)
        {
            foreach (var side in new[] { OffsetSide.In, OffsetSide.Out })
            {
                var before = default(double?);
                foreach (var size in sizes)
                {
                    var (result, milliseconds) = Timed(create(size), side, stop);
                    yield return Row(name, side, size, milliseconds, milliseconds / before, result);
                    before = milliseconds;
                }
            }
        }
    }

    private static (OffsetResult Result, double Milliseconds) Timed(OffsetContour contour, OffsetSide side, CancellationToken stop)
    {
        var times = new double[contour.Segments.Count is > NoRun and < ShortRun ? MoreRuns : Runs];
        var result = ContourOffset.Offset([contour], Distance, side, OffsetOptions.Round(DrawingSettings.Default.MaxErrorMm)); // compiles what is measured
        for (var i = 0; i < times.Length; i++)
        {
            stop.ThrowIfCancellationRequested();
            GC.Collect();
            var before = Environment.CpuUsage.TotalTime;
            result = ContourOffset.Offset([contour], Distance, side, OffsetOptions.Round(DrawingSettings.Default.MaxErrorMm));
            times[i] = (Environment.CpuUsage.TotalTime - before).TotalMilliseconds;
        }

        Array.Sort(times);
        return (result, times[times.Length / 2]);
    }

    private static string Row(string name, OffsetSide side, int size, double milliseconds, double? ratio, OffsetResult result) => string.Create(
        CultureInfo.InvariantCulture,
        $"| {name} | {(side == OffsetSide.In ? "in" : "out")} | {size} | {milliseconds:0.0} | {ratio:0.0} | {result.Loops.Count} | {result.Loops.Count(IsOpen)} | {result.Unresolved.Count} | {result.MaxDeviation:0.0e+0} |");

    private static bool IsOpen(OffsetLoop loop) => !loop.Closed || loop.Segments[^1].End != loop.Segments[0].Start;
}
