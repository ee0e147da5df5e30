using Engraver.Benchmarks.Trajectories;
using Engraver.Core.Geometry;
using Engraver.Core.Trajectories;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Trajectories;

public class TrajectoryBoundTests
{
    /// <summary>Seeded curves for a commit, and the hundred.</summary>
    private static int Curves => TestExtent.Cases(12, 100, "ENGRAVER_TRAJECTORY_CURVES");

    /// <summary>The points of sace-xps-agie.md 3.4, column "centred", and the acceptance of issue 14.</summary>
    [Theory]
    [InlineData("circle", 0.001, 22)]
    [InlineData("circle", 0.002, 19)]
    [InlineData("circle", 0.004, 16)]
    [InlineData("ellipse 10 5", 0.001, 25)]
    [InlineData("ellipse 20 5", 0.001, 25)]
    [InlineData("ellipse 10 2.5", 0.001, 21)]
    [InlineData("rounded rectangle", 0.001, 61)]
    public void The_points_are_as_few_as_the_reference_needs(string shape, double error, int most)
    {
        var trajectory = Assert.Single(Plan(ShapeOf(shape), closed: true, error).Trajectories);

        Assert.InRange(trajectory.Points, 4, most);
        Assert.True(trajectory.Closed);
        HoldsItsBound(trajectory, error);
    }

    [Fact]
    public void No_sample_of_a_random_curve_is_beyond_its_bound_and_no_bound_beyond_the_error()
    {
        for (var seed = 0; seed < Curves; seed++)
        {
            var (segments, closed) = Shapes.Random(seed);
            var error = (seed % 3) switch { 0 => 0.001, 1 => 0.002, _ => 0.01 };
            var result = Plan(segments, closed, error);

            Assert.Empty(result.Unproven);
            Assert.True(Math.Abs(result.Trajectories.Sum(one => one.Length) - segments.Sum(one => one.Length)) < 1e-3, $"seed {seed}");
            foreach (var trajectory in result.Trajectories) HoldsItsBound(trajectory, error);
        }
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(1000.0)]
    public void The_bound_is_near_what_is_measured_so_that_it_wastes_no_points(double size)
    {
        var trajectory = Assert.Single(Plan(Shapes.Ellipse(10.0 * size, 5.0 * size), closed: true, 0.001 * size).Trajectories);
        var measured = new SplineEvaluation(trajectory.Lines).FromSource(trajectory.Source);

        Assert.InRange(trajectory.VerifiedBound, measured, 1.1 * measured);
    }

    [Fact]
    public void Equal_steps_have_their_error_computed_however_large_it_is()
    {
        var result = TrajectoryPlanner.Plan(Shapes.Ellipse(20.0, 5.0), closed: true, new TrajectoryOptions(0.001) { SegmentLength = 2.0 });
        var trajectory = Assert.Single(result.Trajectories);
        var run = new SplineEvaluation(trajectory.Lines);
        var measured = Math.Max(run.FromSource(trajectory.Source), run.ToSource(trajectory.Source));

        Assert.True(measured > 0.1, "Two millimetres are far too long at the tips of the ellipse.");
        Assert.InRange(trajectory.VerifiedBound, measured, 1.2 * measured);
        Assert.InRange(trajectory.SpacingRatio, 1.0, 1.2);
    }

    [Fact]
    public void A_polyline_with_corners_becomes_a_trajectory_for_each_edge()
    {
        var trajectories = Plan(Shapes.Polyline, closed: false, 0.001).Trajectories;

        Assert.Equal([2, 2, 2, 2], trajectories.Select(one => one.Points));
        Assert.All(trajectories, one => Assert.InRange(one.VerifiedBound, 0.0, 1e-8));
        Assert.Equal(trajectories.Skip(1).Select(one => one.Start), trajectories.SkipLast(1).Select(one => one.End));
    }

    [Theory]
    [InlineData(0.001)]
    [InlineData(0.004)]
    public void A_polyline_run_through_keeps_the_error_at_its_corners(double error)
    {
        var result = TrajectoryPlanner.Plan(Shapes.Polyline, closed: false, new TrajectoryOptions(error) { Corners = CornerMode.Continuous });
        var trajectory = Assert.Single(result.Trajectories);

        Assert.InRange(trajectory.Points, 8, 40);
        HoldsItsBound(trajectory, error);
    }

    [Fact]
    public void A_closed_curve_is_a_periodic_spline()
    {
        var lines = Assert.Single(Plan(Shapes.Circle(10.0), closed: true, 0.001).Trajectories).Lines;

        Assert.Equal(lines[1], lines[^2]);
        Assert.Equal(lines[^3], lines[0]);
        Assert.Equal(lines[2], lines[^1]);
    }

    [Fact]
    public void The_phantoms_of_an_open_curve_give_the_tangents_of_its_ends()
    {
        var trajectory = Assert.Single(Plan([Shapes.Arc(0.0, 0.0, 10.0, 0.0, 100.0)], closed: false, 0.001).Trajectories);
        var (first, last) = (trajectory.Lines[2] - trajectory.Lines[0], trajectory.Lines[^1] - trajectory.Lines[^3]);

        Assert.InRange(Math.Abs(first.TurnTo(new Vector2D(0.0, 1.0)).Degrees), 0.0, 1e-6);
        Assert.InRange(Math.Abs(last.TurnTo(trajectory.Source[0].EndTangent).Degrees), 0.0, 1e-6);
        Assert.Equal((new Point2D(10.0, 0.0), 0.0), (trajectory.Start, Math.Round(trajectory.End.DistanceTo(trajectory.Source[0].End), 8)));
    }

    [Fact]
    public void The_number_of_points_is_linear_in_the_length()
    {
        int PointsOf(int arcs) => Plan([.. Enumerable.Range(0, arcs).Select(i => Shapes.Arc(20.0 * i, 0.0, 10.0, i % 2 == 0 ? 180.0 : -180.0, i % 2 == 0 ? -180.0 : 180.0))], closed: false, 0.001).Trajectories.Single().Points;
        var (few, many) = (PointsOf(4), PointsOf(16));

        Assert.InRange(many, 3 * few, 4.5 * few);
    }

    /// <summary>Steps that are long compared with the bends of a curve of tens of metres: no cusp.</summary>
    [Theory]
    [InlineData(50_000, 30_000, 120_000, -20_000, 180_000, 10_000)]
    [InlineData(60_000, 100, 120_000, -100, 190_000, 50)]
    [InlineData(6_000, 10, 12_000, -10, 19_000, 5)]
    public void A_spline_of_many_metres_keeps_the_error_of_a_small_one(double x1, double y1, double x2, double y2, double x3, double y3)
    {
        var trajectory = Assert.Single(Plan([Bezier(x1, y1, x2, y2, x3, y3)], closed: false, 0.001).Trajectories);

        Assert.InRange(trajectory.Points, 4, 1000);
        HoldsItsBound(trajectory, 0.001);
    }

    /// <summary>Placed knots and measured steps; a thousand million of them took ten seconds and more.</summary>
    [Theory]
    [InlineData(0.1)]
    [InlineData(0.001)]
    [InlineData(0.0)] // a cusp
    public void The_work_beside_a_cusp_is_that_of_any_curve(double x)
    {
        var search = new SpacingSearch(SmoothChain.From([Bezier(10.0, 10.0, x, 10.0, 10.0, 0.0)], closed: false), 0.001);

        Assert.NotNull(search.Find());
        Assert.InRange(search.Work, 1, 300_000);
    }

    private static Segment Bezier(double x1, double y1, double x2, double y2, double x3, double y3) =>
        Segment.FromCurve(new RationalCurve(SegmentKind.Spline, [new BezierSpan([0.0, 0.0, 0.0, 1.0, x1, y1, 0.0, 1.0, x2, y2, 0.0, 1.0, x3, y3, 0.0, 1.0])]));

    internal static TrajectoryResult Plan(IReadOnlyList<Segment> segments, bool closed, double error) => TrajectoryPlanner.Plan(segments, closed, new TrajectoryOptions(error));

    internal static void HoldsItsBound(Trajectory trajectory, double error)
    {
        const double Rounding = 1e-9;
        var run = new SplineEvaluation(trajectory.Lines);
        Assert.InRange(trajectory.VerifiedBound, 0.0, error);
        Assert.InRange(run.FromSource(trajectory.Source), 0.0, trajectory.VerifiedBound + Rounding);
        Assert.InRange(run.ToSource(trajectory.Source), 0.0, trajectory.VerifiedBound + Rounding);
        Assert.InRange(trajectory.SpacingRatio, 1.0, 4.0);
    }

    internal static IReadOnlyList<Segment> ShapeOf(string name) => name switch
    {
        "circle" => Shapes.Circle(10.0),
        "ellipse 10 5" => Shapes.Ellipse(10.0, 5.0),
        "ellipse 20 5" => Shapes.Ellipse(20.0, 5.0),
        "ellipse 10 2.5" => Shapes.Ellipse(10.0, 2.5),
        _ => Shapes.RoundedRectangle(40.0, 20.0, 4.0),
    };
}
