using System.Globalization;
using Engraver.Benchmarks.Trajectories;
using Engraver.Core.Geometry;
using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;
using Xunit.Sdk;

namespace Engraver.Core.Tests.Trajectories;

/// <summary>The defects of the SACETraj plug-in (sace-xps-agie.md 1.4), each as a rule that this program fulfils and the plug-in's generator
/// violates.</summary>
public class PlugInDefectTests
{
    /// <summary>"The guaranteed error is not met."</summary>
    [Theory]
    [InlineData("circle", 0.001)]
    [InlineData("circle", 0.002)]
    [InlineData("circle", 0.004)]
    [InlineData("ellipse 20 5", 0.001)]
    [InlineData("ellipse 20 5", 0.002)]
    [InlineData("ellipse 20 5", 0.004)]
    [InlineData("ellipse 10 2.5", 0.001)]
    [InlineData("rounded rectangle", 0.001)]
    [InlineData("rounded rectangle", 0.004)]
    public void The_error_asked_for_is_kept(string shape, double error)
    {
        var segments = TrajectoryBoundTests.ShapeOf(shape);
        var ours = Assert.Single(TrajectoryBoundTests.Plan(segments, closed: true, error).Trajectories);

        OnlyThePlugInBreaks(lines => Assert.InRange(new SplineEvaluation(lines).FromSource(segments), 0.0, error), ours.Lines, PlugInGenerator.Dynamic(segments, error));
        TrajectoryBoundTests.HoldsItsBound(ours, error);
    }

    /// <summary>The generator here is the one that was measured: sace-xps-agie.md 3.4, column "paper", on curves without joints.</summary>
    [Theory]
    [InlineData("circle", 0.001, 178, 0.00134)]
    [InlineData("circle", 0.004, 89, 0.00536)]
    [InlineData("ellipse 20 5", 0.002, 130, 0.00209)]
    [InlineData("ellipse 10 2.5", 0.001, 130, 0.00105)]
    public void The_plug_ins_generator_gives_the_points_and_deviations_that_were_measured(string shape, double error, int points, double deviation)
    {
        var lines = PlugInGenerator.Dynamic(TrajectoryBoundTests.ShapeOf(shape), error);

        Assert.Equal((points, deviation), (lines.Count - 2, Math.Round(new SplineEvaluation(lines).FromSource(TrajectoryBoundTests.ShapeOf(shape)), 5)));
    }

    /// <summary>"Corners blow up": it runs backwards by 2/27 of the long step.</summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void At_corners_and_tangent_joints_the_spline_never_runs_backwards(bool rounded)
    {
        var (segments, ours) = AtJoints(rounded);

        OnlyThePlugInBreaks(RunsForwards, ours.Lines, PlugInGenerator.Dynamic(segments, 0.001));
    }

    /// <summary>"After 16 points at eps/8 the next spacing may be 10 mm."</summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void At_corners_and_tangent_joints_neighbouring_steps_stay_alike(bool rounded)
    {
        var (segments, ours) = AtJoints(rounded);

        OnlyThePlugInBreaks(lines => Assert.All(Steps(lines).Zip(Steps(lines).Skip(1)), pair => Assert.InRange(pair.First / pair.Second, 1.0 / 4.0, 4.0)), ours.Lines, PlugInGenerator.Dynamic(segments, 0.001));
    }

    /// <summary>"Tangent joints count as corners: 16 useless points at each."</summary>
    [Fact]
    public void A_tangent_joint_is_no_corner()
    {
        IReadOnlyList<Segment> segments = [Shapes.Line(-20.0, -4.0, 0.0, -4.0), Shapes.Arc(0.0, 0.0, 4.0, -90.0, 90.0)];
        var ours = Assert.Single(TrajectoryBoundTests.Plan(segments, closed: false, 0.001).Trajectories);

        OnlyThePlugInBreaks(lines => Assert.All(Steps(lines), step => Assert.True(step > 0.01)), ours.Lines, PlugInGenerator.Dynamic(segments, 0.001));
    }

    /// <summary>"The end tangents are half the chord in length and point along the chord, not the curve."</summary>
    [Fact]
    public void The_phantom_makes_the_end_tangent_as_long_as_the_first_step()
    {
        IReadOnlyList<Segment> segments = [Shapes.Arc(0.0, 0.0, 10.0, 0.0, 100.0)];
        var ours = Assert.Single(TrajectoryBoundTests.Plan(segments, closed: false, 0.001).Trajectories);

        OnlyThePlugInBreaks(lines => Assert.Equal(1.0, (lines[2] - lines[0]).Length / 2.0 / lines[1].DistanceTo(lines[2]), 0.02), ours.Lines, PlugInGenerator.Dynamic(segments, 0.001));
        OnlyThePlugInBreaks(lines => Assert.InRange((lines[2] - lines[0]).TurnTo(new Vector2D(0.0, 1.0)).Abs().Degrees, 0.0, 0.001), ours.Lines, PlugInGenerator.Dynamic(segments, 0.001));
    }

    /// <summary>"A corner within eps of the start deletes the start point."</summary>
    [Fact]
    public void A_corner_near_the_start_keeps_the_start()
    {
        var square = Square(first: 0.0005);
        var ours = TrajectoryBoundTests.Plan(square, closed: false, 0.001).Trajectories;

        OnlyThePlugInBreaks(lines => Assert.Contains(square[0].Start, lines), [.. ours.SelectMany(one => one.Lines)], PlugInGenerator.Dynamic(square, 0.001));
    }

    /// <summary>Every corner is visited, also the one at which a closed contour begins.</summary>
    [Theory]
    [InlineData(0.0005)]
    [InlineData(0.0)]
    public void Every_corner_is_the_end_of_a_trajectory(double first)
    {
        var square = Square(first);
        var ours = TrajectoryBoundTests.Plan(square, closed: true, 0.001).Trajectories;
        Point2D[] corners = [new(10.0, 0.0), new(10.0, 10.0), new(0.0, 10.0), new(0.0, 0.0)];

        OnlyThePlugInBreaks(visited => Assert.Superset(corners.ToHashSet(), visited.ToHashSet()), [.. ours.Select(one => one.Start)], PlugInGenerator.Dynamic(square, 0.001));
        Assert.Equal(40.0, ours.Sum(one => one.Length), precision: 9);
    }

    /// <summary>"Every new point rescans to the end: scan work grew 62 x for 16 x length on a scaled ellipse." Here the work is the number of placed knots and
    /// measured steps, counted and not timed.</summary>
    [Theory]
    [InlineData(0.02)]
    [InlineData(0.004)]
    public void Sixteen_times_the_length_is_at_most_sixteen_times_the_work(double error)
    {
        var (small, large) = (Shapes.Ellipse(20.0, 5.0), Shapes.Ellipse(320.0, 80.0));
        PlugInGenerator.Dynamic(small, error, out var theirs);
        PlugInGenerator.Dynamic(large, error, out var theirsOfLarge);

        Assert.InRange((double)theirsOfLarge / theirs, 40.0, 80.0);
        Assert.InRange((double)WorkOn(large, closed: true, error) / WorkOn(small, closed: true, error), 0.1, 16.0);
    }

    /// <summary>The same features sixteen times, with 127 joints instead of 7: proportionally more points, and the same work for each of them.</summary>
    [Fact]
    public void The_work_grows_with_the_number_of_features()
    {
        var (few, many) = (Waves(8), Waves(128));
        var (points, pointsOfMany) = (TrajectoryBoundTests.Plan(few, closed: false, 0.001).Trajectories.Sum(one => one.Points), TrajectoryBoundTests.Plan(many, closed: false, 0.001).Trajectories.Sum(one => one.Points));

        Assert.InRange((double)pointsOfMany / points, 16.0, 127.0 / 7.0);
        Assert.InRange((double)WorkOn(many, closed: false, 0.001) / WorkOn(few, closed: false, 0.001), 0.1, 127.0 / 7.0);
    }

    private static long WorkOn(IReadOnlyList<Segment> segments, bool closed, double error)
    {
        var search = new SpacingSearch(SmoothChain.From(segments, closed), error);
        Assert.InRange(search.Find()!.Value.Bound, 0.0, error);
        return search.Work;
    }

    /// <summary>Half circles of radius 3, up and down in turn.</summary>
    private static IReadOnlyList<Segment> Waves(int count) => [.. Enumerable.Range(0, count).Select(i => Shapes.Arc(6.0 * i, 0.0, 3.0, 180.0, i % 2 == 0 ? -180.0 : 180.0))];

    /// <summary>"Uniform mode often appends the end point twice": in 7 of 14 runs.</summary>
    [Fact]
    public void No_step_of_the_uniform_density_is_without_length()
    {
        var broken = 0;
        foreach (var step in (double[])[0.5, 0.3, 1.7])
        {
            foreach (var (segments, closed) in Enumerable.Range(0, 8).Select(Shapes.Random).Append((Shapes.Circle(10.0), true)))
            {
                foreach (var one in TrajectoryPlanner.Plan(segments, closed, new TrajectoryOptions(0.001) { SegmentLength = step }).Trajectories)
                {
                    Assert.All(Steps(one.Lines), length => Assert.InRange(length, 0.4 * Math.Min(step, one.Length), 1.05 * step));
                }

                if (Steps(PlugInGenerator.Uniform(segments, step)).Any(length => length < 1e-9)) broken++;
            }
        }

        Assert.InRange(broken, 3, 27);
    }

    /// <summary>"Length below eps returns silently without a trajectory."</summary>
    [Fact]
    public void A_segment_shorter_than_the_error_is_a_trajectory_too()
    {
        IReadOnlyList<Segment> segments = [Shapes.Line(1.0, 1.0, 1.0004, 1.0)];
        var ours = Assert.Single(TrajectoryBoundTests.Plan(segments, closed: false, 0.001).Trajectories);

        OnlyThePlugInBreaks(lines => Assert.Equal([new Point2D(1.0, 1.0), new Point2D(1.0004, 1.0)], lines.Skip(1).SkipLast(1)), ours.Lines, PlugInGenerator.Dynamic(segments, 0.001));
    }

    /// <summary>"Cancel sets eps = 0: division by zero."</summary>
    [Fact]
    public void An_error_of_nothing_is_refused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => TrajectoryBoundTests.Plan(Shapes.Circle(10.0), closed: true, 0.0));
        Assert.Throws<OverflowException>(() => PlugInGenerator.Dynamic(Shapes.Circle(10.0), 0.0));
    }

    /// <summary>"If the culture writes decimal commas the line becomes ambiguous."</summary>
    [Theory]
    [InlineData(TrajectoryFormat.Sace)]
    [InlineData(TrajectoryFormat.XpsSpline)]
    [InlineData(TrajectoryFormat.XpsLineArc)]
    [InlineData(TrajectoryFormat.XpsPvt)]
    public void Numbers_are_invariant_in_every_culture(TrajectoryFormat format)
    {
        var segments = Shapes.RoundedRectangle(40.0, 20.0, 4.0);
        string Ours() => TrajectoryFiles.Write(segments, closed: true, new TrajectoryOptions(0.001), format, new TrajectoryMotion(20.0, 256.0)).Files[0].Text;
        string PlugIns() => PlugInGenerator.Text(PlugInGenerator.Dynamic(segments, 0.004), CultureInfo.CurrentCulture);
        var (german, invariant) = (CultureInfo.GetCultureInfo("de-DE"), CultureInfo.InvariantCulture);

        Assert.Equal(In(invariant, Ours), In(german, Ours));
        Assert.DoesNotContain("E-", Ours(), StringComparison.Ordinal);
        Assert.NotEqual(In(invariant, PlugIns), In(german, PlugIns));
    }

    private static string In(CultureInfo culture, Func<string> write)
    {
        var before = CultureInfo.CurrentCulture;
        try
        {
            CultureInfo.CurrentCulture = culture;
            return write();
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    /// <summary>A rule is a test of the defect only if the plug-in's lines violate it.</summary>
    private static void OnlyThePlugInBreaks(Action<IReadOnlyList<Point2D>> rule, IReadOnlyList<Point2D> ours, List<Point2D> plugIns)
    {
        rule(ours);
        Assert.ThrowsAny<XunitException>(() => rule(plugIns));
    }

    /// <summary>The rounded rectangle, or the polyline through its corners.</summary>
    private static (IReadOnlyList<Segment> Segments, Trajectory Ours) AtJoints(bool rounded)
    {
        var segments = rounded ? Shapes.RoundedRectangle(40.0, 20.0, 4.0) : Shapes.Polyline;
        return (segments, Assert.Single(TrajectoryPlanner.Plan(segments, rounded, new TrajectoryOptions(0.001) { Corners = CornerMode.Continuous }).Trajectories));
    }

    /// <summary>Closed, starting at the given distance before a corner.</summary>
    private static IReadOnlyList<Segment> Square(double first)
    {
        Segment[] sides = [Shapes.Line(10.0 - first, 0.0, 10.0, 0.0), Shapes.Line(10.0, 0.0, 10.0, 10.0), Shapes.Line(10.0, 10.0, 0.0, 10.0), Shapes.Line(0.0, 10.0, 0.0, 0.0), Shapes.Line(0.0, 0.0, 10.0 - first, 0.0)];
        return [.. sides.Where(side => side.Length > 0.0)];
    }

    private static void RunsForwards(IReadOnlyList<Point2D> lines)
    {
        var places = new SplineEvaluation(lines, 40).Places;
        for (var i = 2; i < places.Count; i++)
        {
            var (before, after) = (new Vector2D(places[i - 1].X - places[i - 2].X, places[i - 1].Y - places[i - 2].Y), new Vector2D(places[i].X - places[i - 1].X, places[i].Y - places[i - 1].Y));
            Assert.True(before.Dot(after) > 0.0, $"The spline turns back near {places[i]}.");
        }
    }

    private static IEnumerable<double> Steps(IReadOnlyList<Point2D> lines) => Enumerable.Range(1, lines.Count - 3).Select(i => lines[i].DistanceTo(lines[i + 1]));
}
