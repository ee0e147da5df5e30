using System.Globalization;
using Engraver.Benchmarks.Trajectories;
using Engraver.Core.Geometry;
using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Trajectories;

/// <summary>The files of an XPS controller (sace-xps-agie.md 2).</summary>
public class XpsFileTests
{
    private static readonly TrajectoryMotion s_motion = new(20.0, 256.0);

    /// <summary>The example of sace-xps-agie.md 2.2.</summary>
    [Fact]
    public void The_line_arc_file_of_the_rounded_rectangle_is_that_of_the_reference()
    {
        IReadOnlyList<Segment> whole = Shapes.RoundedRectangle(40.0, 20.0, 4.0);
        IReadOnlyList<Segment> fromMiddle = [Shapes.Line(0.0, -10.0, 16.0, -10.0), .. whole.Skip(1), Shapes.Line(-16.0, -10.0, 0.0, -10.0)];
        var file = Assert.Single(TrajectoryFiles.Write(fromMiddle, closed: true, new TrajectoryOptions(0.001), TrajectoryFormat.XpsLineArc, s_motion).Files);

        Assert.Equal(
            "FirstTangent = 0\nDiscontinuityAngle = 0.01\n\nLine = 16.000000, 0.000000\nArc = 4.000000, 90.000000\nLine = 20.000000, 16.000000\nArc = 4.000000, 90.000000\nLine = -16.000000, 20.000000\nArc = 4.000000, 90.000000\nLine = -20.000000, 4.000000\nArc = 4.000000, 90.000000\nLine = 0.000000, 0.000000\n",
            file.Text);
        Assert.InRange(file.VerifiedBound, 0.0, 1e-9);
    }

    /// <summary>sace-xps-agie.md 2.4: from rest to rest, within speed and acceleration, and no element shorter than the minimum time of the controller: an
    /// element that is too short for the speed is run slower.</summary>
    [Fact]
    public void A_pvt_file_ends_at_rest_and_keeps_the_shortest_time()
    {
        var kept = Assert.Single(TrajectoryFiles.Write(Shapes.RoundedRectangle(40.0, 20.0, 4.0), closed: true, new TrajectoryOptions(0.001), TrajectoryFormat.XpsPvt, s_motion).Files);
        var tiny = Assert.Single(TrajectoryFiles.Write([Shapes.Line(0.0, 0.0, 0.00001, 0.0)], closed: false, new TrajectoryOptions(0.001), TrajectoryFormat.XpsPvt, new TrajectoryMotion(1000.0, 1e6)).Files);

        Assert.Empty(kept.BrokenLimits);
        Assert.EndsWith(", 0.000000", kept.Text.TrimEnd(), StringComparison.Ordinal);
        Assert.InRange(kept.Points, 17, 30);
        Assert.Empty(tiny.BrokenLimits);
        Assert.All(tiny.Text.Trim().Split('\n'), row => Assert.InRange(double.Parse(row.Split(',')[0], CultureInfo.InvariantCulture), 0.0005, 0.001));
    }

    /// <summary>The speed along a line is independent of the distance from it.</summary>
    [Fact]
    public void A_straight_line_run_from_rest_to_rest_has_the_bound_of_its_rounding()
    {
        var file = Assert.Single(TrajectoryFiles.Write([Shapes.Line(1.0, 2.0, 77.0, 33.0)], closed: false, new TrajectoryOptions(0.001), TrajectoryFormat.XpsPvt, s_motion).Files);

        Assert.InRange(file.VerifiedBound, 0.0, 1e-8);
    }

    /// <summary>Near its inflection a long spline has arcs of many kilometres: a rounded angle of nine decimals moved their ends by a micrometre, and the file
    /// was not written.</summary>
    [Theory]
    [InlineData(TrajectoryFormat.XpsLineArc, 1_800.0)]
    [InlineData(TrajectoryFormat.XpsLineArc, 18_000.0)]
    [InlineData(TrajectoryFormat.XpsLineArc, 180_000.0)]
    [InlineData(TrajectoryFormat.XpsSpline, 180_000.0)]
    public void A_spline_of_many_metres_keeps_its_error(TrajectoryFormat format, double length)
    {
        var spline = Segment.FromCurve(new RationalCurve(SegmentKind.Spline, [new BezierSpan([0.0, 0.0, 0.0, 1.0, length / 3.0, length / 2.0, 0.0, 1.0, 2.0 * length / 3.0, -length / 2.0, 0.0, 1.0, length, 0.0, 0.0, 1.0])]));

        var file = Assert.Single(TrajectoryFiles.Write([spline], closed: false, new TrajectoryOptions(0.001), format, s_motion).Files);

        Assert.InRange(file.VerifiedBound, 1e-6, 0.001);
        Assert.InRange(file.SampledError, 0.25 * file.VerifiedBound, file.VerifiedBound);
        Assert.InRange(file.Points, 50, 2_000);
    }

    [Theory]
    [InlineData(TrajectoryFormat.XpsLineArc)]
    [InlineData(TrajectoryFormat.XpsPvt)]
    public void The_sampled_error_of_an_ellipse_is_near_its_bound_and_never_beyond(TrajectoryFormat format)
    {
        var file = Assert.Single(TrajectoryFiles.Write(Shapes.Ellipse(10.0, 5.0), closed: true, new TrajectoryOptions(0.001), format, s_motion).Files);

        Assert.InRange(file.SampledError, 0.25 * file.VerifiedBound, file.VerifiedBound);
    }

    /// <summary>The first two control points coincide: the curvature grows there without bound, as 1 over the root of the length.</summary>
    [Fact]
    public void A_spline_that_begins_at_a_doubled_control_point_is_divided_towards_it()
    {
        var curve = Segment.FromCurve(FreeCurves.Spline(3, [new(0, 0), new(0, 0), new(10, 0), new(10, 10)], [1, 1, 1, 1]));
        var file = Assert.Single(TrajectoryFiles.Write([curve], closed: false, new TrajectoryOptions(0.001), TrajectoryFormat.XpsPvt, s_motion).Files);

        Assert.InRange(file.VerifiedBound, 1e-9, 0.001);
        Assert.InRange(file.SampledError, 0.0, file.VerifiedBound);
        Assert.InRange(file.Points, 5, 200);
        Assert.Empty(file.BrokenLimits);
    }

    /// <summary>A bend below 0.05 degrees is passed without a stop if the error allows it; between long lines, which the file does not divide, it does not, and
    /// the machine stops there.</summary>
    [Theory]
    [InlineData(TrajectoryFormat.Sace, 120.0)]
    [InlineData(TrajectoryFormat.XpsSpline, 120.0)]
    [InlineData(TrajectoryFormat.XpsPvt, 120.0)]
    [InlineData(TrajectoryFormat.XpsPvt, 1.0)]
    public void A_small_bend_between_lines_keeps_the_error(TrajectoryFormat format, double length)
    {
        var bend = Angle.FromDegrees(0.04);
        Segment[] path = [Shapes.Line(0.0, 0.0, length, 0.0), Shapes.Line(length, 0.0, length * (1.0 + bend.Cos()), length * bend.Sin())];
        var files = TrajectoryFiles.Write(path, closed: false, new TrajectoryOptions(0.001), format, s_motion).Files;

        Assert.Equal(length > 100.0 ? 2 : 1, files.Count);
        Assert.All(files, file => Assert.InRange(file.VerifiedBound, 0.0, 0.001));
    }

    /// <summary>Control points that coincide, or nearly, at an end or inside; slow and fast machines.</summary>
    [Fact]
    public void Splines_of_uneven_speed_keep_the_limits_of_the_machine()
    {
        for (var seed = 0; seed < TestExtent.Cases(40, 1000, "ENGRAVER_PVT_CURVES"); seed++)
        {
            var (curve, machine) = (Uneven(new Random(seed)), new TrajectoryMotion(20.0 * (1 + (seed % 5)), 64.0 * (1 + (seed % 7))));
            var files = TrajectoryFiles.Write([curve], closed: false, new TrajectoryOptions(0.001), TrajectoryFormat.XpsPvt, machine).Files;
            Assert.Equal(curve.Length, files.Sum(file => file.Length), 6);
            foreach (var file in files)
            {
                Assert.True(file.BrokenLimits.Count == 0, $"seed {seed}, {file.Points} points: {string.Join("; ", file.BrokenLimits.Take(2))}");
                Assert.InRange(file.VerifiedBound, file.SampledError, 0.001);
            }
        }
    }

    /// <summary>Two spans of a cubic spline; a random number of neighbouring control points is moved together, completely or to a thousandth.</summary>
    private static Segment Uneven(Random random)
    {
        var points = Enumerable.Range(0, 5).Select(_ => new Point2D(40.0 * random.NextDouble(), 40.0 * random.NextDouble())).ToArray();
        foreach (var place in new[] { 0, 3, random.Next(4) }.Where(_ => random.Next(2) == 0))
        {
            var share = random.Next(3) switch { 0 => 0.0, 1 => 1e-3, _ => 0.03 };
            points[place + 1] = points[place] + ((points[place + 1] - points[place]) * share);
        }

        return Segment.FromCurve(FreeCurves.Spline(3, points, [1, 1, 1, 1, 1]));
    }

    /// <summary>Some programs write a polygon as a spline with triple points: straight pieces with zero speed at their ends.</summary>
    [Theory]
    [InlineData(TrajectoryFormat.Sace)]
    [InlineData(TrajectoryFormat.XpsLineArc)]
    [InlineData(TrajectoryFormat.XpsSpline)]
    [InlineData(TrajectoryFormat.XpsPvt)]
    public void The_straight_pieces_of_a_spline_with_triple_points_are_lines(TrajectoryFormat format)
    {
        var (a, b, c) = (new Point2D(-1227.9772, 416.6468), new Point2D(-1271.4778, 416.6468), new Point2D(-1288.7016, 462.1777));
        var curve = Segment.FromCurve(FreeCurves.Spline(3, [a, a, b, b, b, b, c, c], [1, 1, 1, 1, 1, 1, 1, 1]));
        var written = TrajectoryFiles.Write([curve], closed: false, new TrajectoryOptions(0.001), format, s_motion);

        Assert.NotEmpty(written.Files);
        Assert.Equal(a.DistanceTo(b) + b.DistanceTo(c), written.Files.Sum(file => file.Length), 6);
        Assert.All(written.Files, file => Assert.InRange(file.SampledError, 0.0, 1e-6));
    }

    [Theory]
    [InlineData(TrajectoryFormat.Sace)]
    [InlineData(TrajectoryFormat.XpsLineArc)]
    [InlineData(TrajectoryFormat.XpsPvt)]
    public void The_sampled_error_of_a_slanted_line_is_what_rounding_leaves(TrajectoryFormat format)
    {
        var file = Assert.Single(TrajectoryFiles.Write([Shapes.Line(1.0 / 3.0, 1.0 / 7.0, 200.0 / 3.0, 100.0 / 7.0)], closed: false, new TrajectoryOptions(0.001), format, s_motion).Files);

        Assert.InRange(file.SampledError, 1e-12, file.VerifiedBound);
    }

    /// <summary>-69 and -35 of sace-xps-agie.md 2.5: at an even speed v an arc of radius r needs v^2 / r across the path.</summary>
    [Theory]
    [InlineData(TrajectoryFormat.XpsSpline, 0.06)] // the curvature of a spline within the error is not even
    [InlineData(TrajectoryFormat.XpsLineArc, 1e-9)]
    public void The_speed_that_the_axes_can_follow_is_told(TrajectoryFormat format, double near)
    {
        var file = Assert.Single(TrajectoryFiles.Write(Shapes.Circle(4.0), closed: true, new TrajectoryOptions(0.001), format, s_motion).Files);
        var line = Assert.Single(TrajectoryFiles.Write([Shapes.Line(0.0, 0.0, 9.0, 1.0)], closed: false, new TrajectoryOptions(0.001), format, s_motion).Files);

        Assert.InRange(file.MaxSpeed!.Value / Math.Sqrt(256.0 * 4.0), 1.0 - near, 1.0 + near);
        Assert.True(line.MaxSpeed is null or > 1000.0);
    }

    [Theory]
    [InlineData(TrajectoryFormat.XpsSpline)]
    [InlineData(TrajectoryFormat.XpsLineArc)]
    [InlineData(TrajectoryFormat.XpsPvt)]
    public void A_travel_that_is_too_short_is_named(TrajectoryFormat format)
    {
        IReadOnlyList<string> Broken(double x, double y) => Assert.Single(TrajectoryFiles.Write(Shapes.Ellipse(10.0, 5.0), closed: true, new TrajectoryOptions(0.001), format, s_motion with { TravelX = x, TravelY = y }).Files).BrokenLimits;

        Assert.Empty(Broken(20.1, 10.1));
        Assert.Matches("^it is (20|19\\.99|20\\.00)[0-9]* mm long in X; the travel of the machine is 19\\.9", Assert.Single(Broken(19.9, 10.1)));
        Assert.Contains("in Y; the travel of the machine is 9.9", Assert.Single(Broken(20.1, 9.9)), StringComparison.Ordinal);
    }
}
