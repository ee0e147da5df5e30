using Engraver.Benchmarks.Trajectories;
using Engraver.Core.Geometry;
using Engraver.Core.Trajectories;

namespace Engraver.Core.Tests.Trajectories;

/// <summary>A bored hole: the spline in space compared with the helix itself, evaluated here from its formula (sace-xps-agie.md 2.3 and 3.1).</summary>
public class HelixTests
{
    [Theory]
    [InlineData(1.0, 1.0, 0.3, false, 0.001)]
    [InlineData(10.0, 5.0, 2.0, true, 0.001)]
    [InlineData(0.05, 0.02, 0.01, false, 0.0001)]
    [InlineData(2.0, 3.0, 100.0, true, 0.01)] // one steep turn
    public void No_place_of_the_spline_is_farther_from_the_helix_than_the_bound(double radius, double depth, double pitch, bool clockwise, double error)
    {
        var (centre, top) = (new Point2D(3.0, -2.0), 0.5);
        var one = HelixPlanner.Plan(centre, radius, top, depth, pitch, clockwise, error)!;
        var turns = (int)Math.Ceiling(depth / pitch);
        var largest = 0.0;
        for (var i = 1; i + 2 < one.Lines.Count; i++)
        {
            for (var k = 0; k <= 16; k++) largest = Math.Max(largest, FromHelix(At(one, i, k / 16.0)));
        }

        Assert.InRange(one.VerifiedBound, largest, error);
        Assert.InRange(one.Points, (8 * (turns + 1)) + 1, 4000);
        Assert.Equal((top, top - depth), (one.HeightAt(1), Math.Round(one.HeightAt(one.Lines.Count - 2), 9)));
        Assert.Equal(2.0 * Math.PI * radius * (turns + 1), one.Length, precision: 9);

        double FromHelix((double X, double Y, double Z) place)
        {
            var (dx, dy) = (place.X - centre.X, (clockwise ? -1.0 : 1.0) * (place.Y - centre.Y));
            var nearest = double.PositiveInfinity;
            var turn = Math.Atan2(dy, dx);
            if (turn < -1e-3) turn += 2.0 * Math.PI;
            for (var round = 0; round <= turns + 1; round++)
            {
                foreach (var off in Enumerable.Range(-40, 81).Select(i => i * 1e-3))
                {
                    var angle = turn + off + (2.0 * Math.PI * round);
                    var z = top - (depth * Math.Clamp(angle / (2.0 * Math.PI * turns), 0.0, 1.0));
                    nearest = Math.Min(nearest, double.Hypot(double.Hypot(dx - (radius * Math.Cos(angle)), dy - (radius * Math.Sin(angle))), place.Z - z));
                }
            }

            return nearest;
        }
    }

    [Fact]
    public void More_turns_than_anyone_bores_are_refused() => Assert.Null(HelixPlanner.Plan(default, 1.0, 0.0, 1.0, 1e-6, clockwise: false, 0.001));

    [Fact]
    public void A_helix_is_moved_with_all_its_heights()
    {
        var one = HelixPlanner.Plan(default, 1.0, 0.0, 1.0, 0.5, clockwise: false, 0.001)!;

        Assert.Equal(one.Heights!.Select(height => Math.Round(height + 2.5, 9)), one.Moved(2.5).Heights!.Select(height => Math.Round(height, 9)));
    }

    [Theory]
    [InlineData("last knot")]
    [InlineData("first knot")]
    [InlineData("order")]
    [InlineData("count")]
    [InlineData("heights")]
    public void Points_that_do_not_belong_to_their_source_are_not_proven(string what)
    {
        var one = TrajectoryPlanner.Plan([Shapes.Arc(0.0, 0.0, 10.0, 0.0, 100.0)], closed: false, new TrajectoryOptions(0.001)).Trajectories[0];
        var knots = one.Knots.ToList();
        Assert.Equal(one.VerifiedBound, TrajectoryProof.Prove(one.Lines, knots, one.Source, closed: false)!.VerifiedBound);
        if (what == "last knot") knots[^1] -= 0.5;
        if (what == "first knot") knots[0] = 0.1;
        if (what == "order") (knots[1], knots[2]) = (knots[2], knots[1]);
        if (what == "count") knots.RemoveAt(1);

        Assert.Null(TrajectoryProof.Prove(one.Lines, knots, one.Source, closed: false, what == "heights" ? [1.0] : null));
    }

    /// <summary>The points of the segment by the matrix of paper 004, equation 1.</summary>
    private static (double X, double Y, double Z) At(Trajectory one, int i, double u)
    {
        double Of(Func<int, double> p) => p(i) + (u * ((p(i + 1) - p(i - 1)) / 2.0)) + (u * u * (p(i - 1) - (2.5 * p(i)) + (2.0 * p(i + 1)) - (0.5 * p(i + 2)))) + (u * u * u * ((-0.5 * p(i - 1)) + (1.5 * p(i)) - (1.5 * p(i + 1)) + (0.5 * p(i + 2))));
        return (Of(k => one.Lines[k].X), Of(k => one.Lines[k].Y), Of(one.HeightAt));
    }
}
