using Engraver.Core.Geometry;
using Engraver.Core.Verification;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Verification;

/// <summary>The judge and the curves of <see cref="DrawnCurves"/>: a cut on them is correct, a cut 5 counts beside them is not, and an omitted part is
/// missing.</summary>
public class JudgedCurveTests
{
    private const double FiveCounts = 0.005;
    private const double Step = 0.04;

    private static readonly DrawnCurve[] s_curves = [.. DrawnCurves.Known, .. DrawnCurves.Random(seed: 11, count: TestExtent.IsFull ? 64 : 6)];

    [Fact]
    public void A_curve_that_is_cut_as_drawn_is_right()
    {
        foreach (var drawn in s_curves)
        {
            var verdict = Judge(drawn, Whole(drawn));
            Assert.True(verdict is { MaxDeviation: < 1e-6, MissingLength: 0.0, ExtraLength: 0.0 }, $"{drawn}: {verdict}");
        }
    }

    [Fact]
    public void A_place_five_counts_beside_the_curve_is_found()
    {
        foreach (var drawn in s_curves)
        {
            foreach (var parameter in drawn.Parameters(3))
            {
                var along = drawn.Direction(parameter);
                if (!double.IsFinite(along.X)) continue;
                var aside = drawn.At(parameter) + (new Vector2D(-along.Y, along.X) * FiveCounts);
                var expected = drawn.DistanceFrom(aside);
                var verdict = Judge(drawn, [aside]);
                Assert.True(Math.Abs(verdict.MaxDeviation - expected) < 1e-7, $"{drawn} at {aside}: {verdict.MaxDeviation} for {expected}");
            }
        }
    }

    [Fact]
    public void Each_smooth_piece_that_is_left_out_is_missing()
    {
        var tried = 0;
        foreach (var drawn in s_curves)
        {
            for (var i = 0; i + 1 < drawn.Breaks.Count; i++)
            {
                var (from, to) = (drawn.Breaks[i], drawn.Breaks[i + 1]);
                IReadOnlyList<Point2D> before = i == 0 ? [] : drawn.Trace(drawn.Breaks[0], from, Step);
                IReadOnlyList<Point2D> after = i + 2 == drawn.Breaks.Count ? [] : drawn.Trace(to, drawn.Breaks[^1], Step);
                var left = LengthFarFrom(drawn.Trace(from, to, 0.01), [before, after]);
                if (left < 0.5) continue;
                tried++;
                var verdict = Judge(drawn, before, after);
                Assert.True(Math.Abs(verdict.MissingLength - left) < (0.15 * left) + 0.1, $"{drawn}, piece {i}: {verdict.MissingLength} for {left}");
            }
        }

        Assert.InRange(tried, TestExtent.IsFull ? 80 : 20, 10_000);
    }

    private static List<Point2D> Whole(DrawnCurve drawn) => drawn.Trace(drawn.Breaks[0], drawn.Breaks[^1], Step);

    /// <summary>The length of the parts of a fine chain that are not near the points of the other.</summary>
    private static double LengthFarFrom(List<Point2D> chain, IReadOnlyList<Point2D>[] others)
    {
        var edges = others.SelectMany(other => other.Zip(other.Skip(1), (a, b) => new LineSegment(a, b))).ToArray();
        var length = 0.0;
        for (var i = 1; i < chain.Count; i++)
        {
            var middle = chain[i - 1] + ((chain[i] - chain[i - 1]) * 0.5);
            if (!edges.Any(edge => edge.DistanceTo(middle) <= UsualOptions.Trace.Coverage)) length += chain[i - 1].DistanceTo(chain[i]);
        }

        return length;
    }

    private static TraceVerdict Judge(DrawnCurve drawn, params IReadOnlyList<Point2D>[] cuts)
    {
        var trace = new List<TraceSample>();
        foreach (var cut in cuts.Where(cut => cut.Count > 0))
        {
            trace.Add(new TraceSample(trace.Count, cut[0].X, cut[0].Y, false));
            trace.AddRange(cut.Select((place, i) => new TraceSample(trace.Count + i, place.X, place.Y, true)));
        }

        return TraceComparison.Compare([Segment.FromCurve(drawn.Curve)], trace, UsualOptions.Trace);
    }
}
