using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion.Planning;

namespace Engraver.Core.Tests.Motion.Planning;

/// <summary>The plan of single moves against closed forms, and plans of random paths against an integrator that shares nothing with the planner.</summary>
public sealed class SpeedPlannerTests
{
    private const double A = 256000.0;
    private const double Feed = 20000.0;

    /// <summary>Ten commands of 1.6 ms.</summary>
    private const double SequenceSeconds = 0.016;
    private static readonly PathLimits s_limits = PathLimits.Of(MachineProfile.Default);

    [Theory]
    [InlineData(100.0)]
    [InlineData(1562.0)]
    [InlineData(50000.0)]
    public void A_line_takes_the_time_of_its_trapezoid(double length)
    {
        var planner = Planned((length, double.PositiveInfinity, 0.0, 0.0));

        var expected = length >= Feed * Feed / A ? (length / Feed) + (Feed / A) : 2.0 * Math.Sqrt(length / A);
        Assert.Equal(expected, planner.Seconds, 5);
        Assert.Equal((int)A, planner.Acceleration);
    }

    /// <summary>From rest to rest on a circle: the speed v may be reached by VA up to sqrt(VA2 + (v2/r)2) = A, so the time is v/VA + L/v for the best
    /// VA.</summary>
    [Theory]
    [InlineData(100.0)]
    [InlineData(1000.0)]
    public void A_circle_takes_the_least_time_of_any_acceleration(double radius)
    {
        var length = 2.0 * Math.PI * radius;
        var least = Enumerable.Range(1, 999).Select(part => A * part / 1000.0).Min(va => TrapezoidSeconds(length, Math.Min(Feed, Math.Sqrt(radius * Math.Sqrt((A * A) - (va * va)))), va));

        var planner = Planned((length, radius, 0.0, 360.0));

        Assert.InRange(planner.Seconds, least, least * 1.01);
    }

    /// <summary>A corner is passed at the speed whose change of direction takes one sample at A: VA up to it and away from it.</summary>
    [Theory]
    [InlineData(45.0)]
    [InlineData(90.0)]
    public void A_corner_takes_the_time_of_two_ramps_to_its_speed(double turn)
    {
        var through = A * 0.001 / (2.0 * Math.Sin(turn * Math.PI / 360.0));
        const double Side = 500.0;
        var peak = Math.Sqrt((through * through / 2.0) + (A * Side)); // from rest to the corner's speed

        var planner = Planned((Side, double.PositiveInfinity, 0.0, 0.0), (Side, double.PositiveInfinity, turn, turn));

        Assert.Equal(2.0 * (peak + peak - through) / A, planner.Seconds, 4);
    }

    [Fact]
    public void A_bound_of_one_axis_slows_the_lines_along_it()
    {
        var limits = PathLimits.Of(MachineProfile.Default with { AccelerationX = 51200 });
        var along = new SpeedPlanner(limits, 1024);
        along.Add(50000, double.PositiveInfinity, Feed, PathDirection.Of(1, 0, 0), PathDirection.Of(1, 0, 0));
        along.Plan();
        var across = new SpeedPlanner(limits, 1024);
        across.Add(50000, double.PositiveInfinity, Feed, PathDirection.Of(0, 1, 0), PathDirection.Of(0, 1, 0));
        across.Plan();

        Assert.Equal((51200, 256000), (along.Acceleration, across.Acceleration));
    }

    [Fact]
    public void Random_paths_are_run_within_the_limits_and_faster_than_with_a_stop_at_every_corner()
    {
        for (var seed = 1; seed <= 60; seed++)
        {
            var path = RandomPath(new Random(seed));
            var planner = Planned(path);
            var run = new RunOfCommands(path, planner);

            Assert.True(run.LargestTotal <= A * 1.001, $"{seed}: {run.LargestTotal / A}");
            Assert.True(run.LargestJump <= A * 0.001 * 1.02, $"{seed}: {run.LargestJump}");
            Assert.Equal(planner.Seconds, run.Seconds, (planner.Seconds * 0.01) + (BeforeTurn * path.Length));
            Assert.True(run.Seconds <= StopSeconds(path) * 1.0001, $"{seed}: {run.Seconds} {StopSeconds(path)}");
        }
    }

    /// <summary>The longest time for which a brake before a sharp turn lasts longer than its ramp: a sample and a quarter.</summary>
    private const double BeforeTurn = 0.00125;

    private static double TrapezoidSeconds(double length, double speed, double acceleration) =>
        length >= speed * speed / acceleration ? (length / speed) + (speed / acceleration) : 2.0 * Math.Sqrt(length / acceleration);

    /// <summary>Each course from rest to rest, arcs with the best acceleration; a stop needs the commands of another sequence.</summary>
    private static double StopSeconds((double Length, double Radius, double Start, double End)[] path) => path.Sum(course => Planned(course).Seconds + SequenceSeconds) - SequenceSeconds;

    private static SpeedPlanner Planned(params (double Length, double Radius, double Start, double End)[] path)
    {
        var planner = new SpeedPlanner(s_limits, 1024);
        foreach (var (length, radius, start, end) in path) planner.Add(length, radius, Feed, Direction(start), Direction(end));
        planner.Plan();
        return planner;
    }

    private static PathDirection Direction(double degrees) => PathDirection.Of(Vector2D.FromPolar(1.0, Angle.FromDegrees(degrees)));

    /// <summary>Lines and arcs; half of the joints are tangent. No line is so short that it belongs to a polygon.</summary>
    private static (double Length, double Radius, double Start, double End)[] RandomPath(Random random)
    {
        var (path, heading) = (new List<(double, double, double, double)>(), 0.0);
        for (var i = random.Next(1, 40); i > 0; i--)
        {
            if (random.Next(2) == 0) heading += random.Next(-170, 170);
            if (random.Next(2) == 0)
            {
                path.Add((200.0 + (5000.0 * Math.Pow(random.NextDouble(), 3.0)), double.PositiveInfinity, heading, heading));
                continue;
            }

            var (radius, sweep) = (10.0 + (5000.0 * Math.Pow(random.NextDouble(), 3.0)), (random.NextDouble() * 350.0) + 5.0);
            path.Add((radius * sweep * Math.PI / 180.0, radius, heading, heading + sweep));
            heading += sweep;
        }

        return [.. path];
    }

    /// <summary>Runs the commands of a plan in small steps, as a controller does: towards the commanded speed at VA or VD, and to rest at the end.</summary>
    private sealed class RunOfCommands
    {
        private const double Step = 5e-5;

        public RunOfCommands((double Length, double Radius, double Start, double End)[] path, SpeedPlanner planner)
        {
            var (speed, whole, va) = (0.0, path.Sum(course => course.Length), (double)planner.Acceleration);
            for (var i = 0; i < path.Length; i++)
            {
                var (length, radius, start, _) = path[i];
                if (i > 0) LargestJump = Math.Max(LargestJump, 2.0 * speed * Math.Abs(Math.Sin((start - path[i - 1].End) * Math.PI / 360.0)));
                var commands = planner.SpeedsOf(i);
                var along = 0.0;
                while (along < length)
                {
                    var brake = commands.Second == 0 ? length : length - commands.Braking;
                    var target = along >= brake ? commands.Second == 0 ? commands.First : commands.Second : commands.First;
                    var end = along < brake ? brake : length;
                    var step = Math.Min(Math.Max(0.02, speed * Step), end - along);
                    var next = speed < target ? Math.Min(target, Math.Sqrt((speed * speed) + (2.0 * va * step))) : Math.Max(target, Math.Sqrt(Math.Max(0.0, (speed * speed) - (2.0 * va * step))));
                    next = Math.Min(next, Math.Sqrt(2.0 * va * Math.Max(0.0, whole - along - step)));
                    if (Math.Abs(next - speed) > 2.0) LargestTotal = Math.Max(LargestTotal, double.Hypot(va, double.IsInfinity(radius) ? 0.0 : next * next / radius));
                    LargestTotal = Math.Max(LargestTotal, double.IsInfinity(radius) ? 0.0 : next * next / radius);
                    Seconds += 2.0 * step / Math.Max(1e-3, speed + next);
                    (speed, along) = (next, step == end - along ? end : along + step);
                }

                whole -= length;
            }
        }

        public double Seconds { get; }

        public double LargestTotal { get; }

        public double LargestJump { get; }
    }
}
