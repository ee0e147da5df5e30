using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Motion.Planning;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Workbench.Composition;

namespace Engraver.Benchmarks.Plans;

/// <summary>Processor time and memory of speed plans and of whole motion programs of a million segments.</summary>
internal static class PlanBenchmark
{
    private const int Segments = 1_000_000;

    /// <summary>Head of the table, Markdown.</summary>
    public static string Head => "| what | lines | segments | CPU s | bytes per segment in use |\n|---|---:|---:|---:|---:|";

    /// <summary>The rows, in order; each is measured the second time, compiled.</summary>
    public static IEnumerable<string> Rows(CancellationToken stop)
    {
        foreach (var measure in (Func<string>[])[Plan, () => Program("zigzag", Zigzag, false), () => Program("zigzag", Zigzag, true), () => Program("spiral", Spiral, false), () => Program("spiral", Spiral, true)])
        {
            stop.ThrowIfCancellationRequested();
            measure();
            yield return measure();
        }
    }

    private static MachineProfile Machine => MachineProfile.Default with { AccelerationCounts = 1_999_872, FeedMmPerMinute = 6000.0 };

    /// <summary>The planner alone: lines and arcs with random turns, in one sequence. Its memory is in use while a sequence is planned.</summary>
    private static string Plan()
    {
        var random = new Random(1);
        var planner = new SpeedPlanner(PathLimits.Of(Machine), 1024);
        var before = Environment.CpuUsage.TotalTime;
        var heading = 0.0;
        for (var i = 0; i < Segments; i++)
        {
            heading += random.NextDouble() - 0.5;
            var direction = PathDirection.Of(Math.Cos(heading), Math.Sin(heading), 0.0);
            planner.Add(500.0 + (500.0 * random.NextDouble()), i % 3 == 0 ? 2000.0 + (10_000.0 * random.NextDouble()) : double.PositiveInfinity, 100_000.0, direction, direction);
        }

        planner.Plan();
        return Row("speed plan", Segments, Segments, before, [planner]);
    }

    private static string Program(string name, Func<int, Point2D> at, bool fitsArcs)
    {
        var moves = new StrokeMove[Segments];
        for (var i = 0; i < moves.Length; i++) moves[i] = new StrokeMove(Segment.FromLine(at(i), at(i + 1)), 0);
        var path = new Toolpath(default, [new ToolpathStroke(0, false, moves)]);
        var before = Environment.CpuUsage.TotalTime;
        var made = MachineFamilies.DriverOf(Machine).Generate(path, Machine, new MotionTolerances(0.001, 0.01) { FitsArcs = fitsArcs }, null, MotionStyle.Continuous);
        var segments = made.Program!.SegmentCount;
        return Row(name + (fitsArcs ? ", fit-arcs" : ""), Segments, segments, before, null);
    }

    /// <summary>Corners everywhere: each is rounded or slow, and no arcs fit.</summary>
    private static Point2D Zigzag(int i) => new(i / 1000 % 2 == 0 ? i % 1000 * 0.5 : 499.5 - (i % 1000 * 0.5), (i / 1000 * 0.5) + (0.2 * (i % 2)));

    private static Point2D Spiral(int i) => Point2D.Origin + Vector2D.FromPolar(5.0 + (4e-5 * i), Angle.FromRadians(0.002 * i));

    /// <param name="before">Processor time before the work.</param>
    /// <param name="planner">Its memory is what its release frees; null where it is not measured.</param>
    private static string Row(string what, int lines, int segments, TimeSpan before, SpeedPlanner?[]? planner)
    {
        var seconds = (Environment.CpuUsage.TotalTime - before).TotalSeconds;
        return string.Create(CultureInfo.InvariantCulture, $"| {what} | {lines} | {segments} | {seconds:0.00} | {(planner is null ? null : MemoryOf(planner) / segments)} |");
    }

    private static long MemoryOf(SpeedPlanner?[] planner)
    {
        var memory = GC.GetTotalMemory(forceFullCollection: true);
        GC.KeepAlive(planner[0]);
        planner[0] = null;
        return memory - GC.GetTotalMemory(forceFullCollection: true);
    }
}
