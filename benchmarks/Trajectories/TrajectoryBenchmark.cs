using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Trajectories;

namespace Engraver.Benchmarks.Trajectories;

/// <summary>Points, proven bounds and measured errors of trajectories on the shapes of sace-xps-agie.md 3.4, compared with the plug-in's generator, and of
/// seeded random curves.</summary>
internal static class TrajectoryBenchmark
{
    private const int Repetitions = 5;

    /// <summary>The two lines above the rows of the shapes.</summary>
    public const string ShapesHead = "| Curve (mm) | Error limit | Plug-in: points | max. deviation | Points | proven bound | max. deviation | ratio of steps | CPU ms (median) |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|";

    /// <summary>The two lines above the row of the random curves.</summary>
    public const string CurvesHead = "| Random curves | Runs that failed | Points | Max. proven bound / error limit | Max. deviation / proven bound | Max. ratio of steps | CPU ms a curve |\n|---:|---:|---:|---:|---:|---:|---:|";

    private static readonly double[] s_errors = [0.001, 0.002, 0.004];

    private static readonly (string Name, IReadOnlyList<Segment> Segments, bool Closed)[] s_shapes =
    [
        ("circle R10", Shapes.Circle(10.0), true), ("ellipse, semi-axes 10 and 5", Shapes.Ellipse(10.0, 5.0), true), ("ellipse, semi-axes 20 and 5", Shapes.Ellipse(20.0, 5.0), true),
        ("ellipse, semi-axes 10 and 2.5", Shapes.Ellipse(10.0, 2.5), true), ("rounded rectangle 40 x 20, r 4", Shapes.RoundedRectangle(40.0, 20.0, 4.0), true), ("polyline of four edges, run through", Shapes.Polyline, false),
    ];

    /// <summary>Plans every shape a few times, so that the rows do not include the just-in-time compiler.</summary>
    public static void WarmUp(CancellationToken stop)
    {
        for (var i = 0; i < Repetitions; i++)
        {
            stop.ThrowIfCancellationRequested();
            foreach (var (_, segments, closed) in s_shapes) Timed(segments, closed, new TrajectoryOptions(s_errors[0]) { Corners = CornerMode.Continuous }, repetitions: 1);
        }
    }

    /// <summary>A row for each shape and error.</summary>
    public static IEnumerable<string> Rows(CancellationToken stop)
    {
        foreach (var (name, segments, closed) in s_shapes)
        {
            foreach (var error in s_errors)
            {
                stop.ThrowIfCancellationRequested();
                yield return Row(name, segments, closed, error);
            }
        }
    }

    /// <summary>One row that sums up the seeds 0 to <paramref name="curves"/> - 1, with the errors 0.001, 0.002 and 0.01 in turn.</summary>
    public static string Curves(int curves, CancellationToken stop)
    {
        var (failed, points, bound, deviation, ratio, cpu) = (0, 0, 0.0, 0.0, 1.0, TimeSpan.Zero);
        for (var seed = 0; seed < curves; seed++)
        {
            stop.ThrowIfCancellationRequested();
            var (segments, closed) = Shapes.Random(seed);
            var error = (seed % 3) switch { 0 => 0.001, 1 => 0.002, _ => 0.01 };
            var before = Environment.CpuUsage.TotalTime;
            var result = TrajectoryPlanner.Plan(segments, closed, new TrajectoryOptions(error));
            cpu += Environment.CpuUsage.TotalTime - before;
            failed += result.Unproven.Count;
            foreach (var one in result.Trajectories)
            {
                points += one.Points;
                (bound, ratio) = (Math.Max(bound, one.VerifiedBound / error), Math.Max(ratio, one.SpacingRatio));
                deviation = Math.Max(deviation, Deviation(one) / one.VerifiedBound);
            }
        }

        return string.Create(CultureInfo.InvariantCulture, $"| {curves} | {failed} | {points} | {bound:0.0000} | {deviation:0.000000} | {ratio:0.00} | {cpu.TotalMilliseconds / curves:0} |");
    }

    private static string Row(string name, IReadOnlyList<Segment> segments, bool closed, double error)
    {
        var plugIn = PlugInGenerator.Dynamic(segments, error);
        var (ours, milliseconds) = Timed(segments, closed, new TrajectoryOptions(error) { Corners = CornerMode.Continuous }, Repetitions);
        return string.Create(
            CultureInfo.InvariantCulture,
            $"| {name} | {error} | {plugIn.Count - 2} | {new SplineEvaluation(plugIn).FromSource(segments):0.00000} | {ours.Points} | {ours.VerifiedBound:0.000000} | {Deviation(ours):0.000000} | {ours.SpacingRatio:0.00} | {milliseconds:0} |");
    }

    private static (Trajectory Made, double Milliseconds) Timed(IReadOnlyList<Segment> segments, bool closed, TrajectoryOptions options, int repetitions)
    {
        var (made, times) = (default(Trajectory), new double[repetitions]);
        for (var i = 0; i < repetitions; i++)
        {
            var before = Environment.CpuUsage.TotalTime;
            made = TrajectoryPlanner.Plan(segments, closed, options).Trajectories.Single();
            times[i] = (Environment.CpuUsage.TotalTime - before).TotalMilliseconds;
        }

        Array.Sort(times);
        return (made!, times[repetitions / 2]);
    }

    /// <summary>In both directions, at samples, evaluated without the generator's code.</summary>
    private static double Deviation(Trajectory trajectory)
    {
        var run = new SplineEvaluation(trajectory.Lines);
        return Math.Max(run.FromSource(trajectory.Source), run.ToSource(trajectory.Source));
    }
}
