using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Verification;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Verification;

/// <summary>A run is compared with the segments nearest to it only, and the remaining parts with the cuts beside them. The result is compared with every pair
/// of a chord and a segment, on random runs along, across and beside random segments.</summary>
public class DrawnCoverageTests
{
    private const int Cases = 300;

    private static readonly TraceTolerances s_tolerances = UsualOptions.Trace;

    /// <summary>A part that a chord came within reach of is not missing. A part that a chord passed at a few reaches may be missing or not.</summary>
    [Fact]
    public void The_judge_covers_what_every_chord_covers_of_every_segment()
    {
        var covered = 0;
        for (var seed = 1; seed <= Cases; seed++)
        {
            var random = new Random(seed);
            var drawing = Drawing(random);
            var run = Run(random, drawing[random.Next(drawing.Length)]);
            var judge = new TraceJudge(drawing, s_tolerances);
            foreach (var place in run) judge.Add(new TraceSample(0.0, place.X, place.Y, true));

            var (found, whole) = (judge.Verdict().MissingLength, drawing.Sum(segment => segment.Length));
            var (most, least) = (MissingOfAll(drawing, run, s_tolerances.Coverage), MissingOfAll(drawing, run, 4.0 * s_tolerances.Coverage));
            var step = 2.0 * drawing.Max(segment => segment.Length / s_tolerances.StepsFor(segment.Length));

            Assert.True(found >= least - step && found <= most + step, FormattableString.Invariant($"seed {seed}: {found} of {whole} mm missing, {least} to {most} by all pairs"));
            if (most < whole - step) covered++;
        }

        Assert.InRange(covered, Cases / 4, Cases); // without covered parts the test would prove nothing
    }

    /// <summary>Lines closer together than a count are cut one by one; each is complete, whichever of them the samples are nearest to.</summary>
    [Theory]
    [InlineData(0.0, 0.0)]
    [InlineData(0.0004, 0.0)]
    [InlineData(0.003, 0.003)]
    [InlineData(0.0, 0.02)]
    [InlineData(0.01, -0.02)]
    public void Lines_on_one_another_are_whole_when_each_was_cut(double apart, double fanned)
    {
        Segment[] drawing = [.. Enumerable.Range(0, 40).Select(i => Segment.FromLine(new Point2D(0, i * apart), new Point2D(40, 30 + (i * (apart + fanned)))))];
        var judge = new TraceJudge(drawing, s_tolerances);
        foreach (var line in drawing)
        {
            judge.Add(new TraceSample(0.0, line.Start.X, line.Start.Y, false));
            for (var i = 0; i <= 2500; i++) judge.Add(new TraceSample(0.0, Math.Round(line.PointAt(i / 2500.0).X, 3), Math.Round(line.PointAt(i / 2500.0).Y, 3), true));
            judge.Add(new TraceSample(0.0, line.End.X, line.End.Y, false));
        }

        var verdict = judge.Verdict();

        Assert.Equal((0.0, null, 0.0), (verdict.MissingLength, verdict.MissingAt, verdict.ExtraLength));
    }

    /// <summary>A cut that leaves one segment follows the next that is near enough, and in a crowd it may be assigned to another for a few samples.</summary>
    [Fact]
    public void Short_lines_under_a_crowd_of_long_ones_are_whole_when_each_was_cut()
    {
        for (var seed = 1; seed <= TestExtent.Cases(perCommit: 5, full: 20, "ENGRAVER_CROWD_SEEDS"); seed++)
        {
            var random = new Random(seed);
            Point2D Near(double most) => new(random.NextDouble() * most, random.NextDouble() * most);
            Point2D Bow(int i) => new(0.5 + (0.3 * Math.Cos(i * 0.1)), 0.5 + (0.3 * Math.Sin(i * 0.1)));
            Segment[] drawing =
            [
                .. Enumerable.Range(0, 150).Select(_ => (Place: Near(1.0), Way: Near(2.0) - new Point2D(1.0, 1.0))).Select(ray => Segment.FromLine(ray.Place - (ray.Way * 30.0), ray.Place + (ray.Way * 30.0))),
                .. Enumerable.Range(0, 60).Select(i => Segment.FromLine(Bow(i), Bow(i + 1))),
            ];
            var judge = new TraceJudge(drawing, s_tolerances);
            foreach (var line in drawing)
            {
                var steps = (int)Math.Ceiling(line.Length / 0.004);
                if (line.Length > 1.0 || line.Start == Bow(0)) judge.Add(new TraceSample(0.0, line.Start.X, line.Start.Y, false));
                for (var i = 0; i <= steps; i++) judge.Add(new TraceSample(0.0, Math.Round(line.PointAt((double)i / steps).X, 3), Math.Round(line.PointAt((double)i / steps).Y, 3), true));
            }

            var verdict = judge.Verdict();

            Assert.True(verdict is { MissingLength: 0.0, ExtraLength: 0.0 }, FormattableString.Invariant($"seed {seed}: {verdict}"));
        }
    }

    /// <summary>In its tight turns the arcs that are cut for a spline turn by more than the pieces that they are compared with, and extend slightly into the
    /// next.</summary>
    [Fact]
    public void Tightly_turning_splines_are_whole_when_arcs_are_cut_for_them()
    {
        for (var seed = 1; seed <= TestExtent.Cases(perCommit: 40, full: 300, "ENGRAVER_TURN_SEEDS"); seed++)
        {
            var random = new Random(seed);
            double Any() => random.NextDouble() * 4.0;
            var spline = new RationalCurve(SegmentKind.Spline, [new BezierSpan([Any(), Any(), 0, 1, Any(), Any(), 0, 1, Any(), Any(), 0, 1, Any(), Any(), 0, 1])]);
            var judge = new TraceJudge([Segment.FromCurve(spline)], s_tolerances);
            foreach (var cut in BiarcFit.Fit(spline, s_tolerances.MaxError)) judge.Add(new TraceSpan(0.0, 1.0, 1000, cut, true));

            var verdict = judge.Verdict();

            Assert.True(verdict.MissingLength == 0.0 && verdict.MaxDeviation <= s_tolerances.Deviation, FormattableString.Invariant($"seed {seed}: {verdict}"));
        }
    }

    /// <summary>At 20 mm/s samples are 0.02 mm apart, and after a span the next starts a sample later.</summary>
    [Theory]
    [InlineData(0.006, false)]
    [InlineData(0.006, true)]
    [InlineData(0.015, false)]
    [InlineData(0.015, true)]
    public void Lines_shorter_than_the_way_between_two_samples_are_whole(double length, bool isBehindSpan)
    {
        Segment[] drawing =
        [
            Segment.FromLine(new Point2D(0, 0), new Point2D(5, 0)),
            Segment.FromLine(new Point2D(5, 0), new Point2D(5 + length, 0)),
            Segment.FromLine(new Point2D(5 + length, 0), new Point2D(10, 0)),
        ];
        var (before, after) = (5.0 + (length / 2.0) - 0.01, 5.0 + (length / 2.0) + 0.01);
        var judge = new TraceJudge(drawing, s_tolerances);
        if (isBehindSpan) judge.Add(new TraceSpan(0.0, 1.0, 1000, Segment.FromLine(default, new Point2D(before, 0)), true));
        else for (var i = 300; i >= 0; i--) judge.Add(new TraceSample(0.0, Math.Max(0.0, before - (i * 0.02)), 0.0, true));
        judge.Add(new TraceSpan(1.0, 2.0, 1000, Segment.FromLine(new Point2D(after, 0), new Point2D(10, 0)), true));

        Assert.Equal(0.0, judge.Verdict().MissingLength);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(7)]
    [InlineData(39)]
    public void A_line_of_a_fan_that_was_not_cut_is_missing_from_where_it_parts_from_the_others(int left)
    {
        Segment[] drawing = [.. Enumerable.Range(0, 40).Select(i => Segment.FromLine(default, new Point2D(50, i)))];
        var judge = new TraceJudge(drawing, s_tolerances);
        for (var i = 0; i < drawing.Length; i++)
        {
            judge.Add(new TraceSample(0.0, 0.0, 0.0, false));
            if (i != left) judge.Add(new TraceSpan(0.0, 1.0, 1000, drawing[i], true));
        }

        Assert.InRange(judge.Verdict().MissingLength, drawing[left].Length - 1.0, drawing[left].Length - 0.1);
    }

    /// <summary>A spline over a circle and a line over a spline: the cut of one also counts for the other.</summary>
    [Fact]
    public void A_curve_that_lies_on_another_is_whole_when_that_was_cut()
    {
        var ellipse = Segment.FromCurve(new EllipseArc(new Vector3D(3, 4, 0), new Vector3D(20, 0, 0), new Vector3D(0, 20, 0), Angle.Zero, Angle.FullTurn).ToCurve());
        var circle = Segment.FromArc(new ArcSegment(new Point2D(3, 4), 20, Angle.FromDegrees(17), Angle.FullTurn));
        foreach (var drawing in (Segment[][])[[ellipse, circle], [circle, ellipse], [ellipse, ellipse]])
        {
            var judge = new TraceJudge(drawing, s_tolerances);
            foreach (var half in (double[])[0.0, 0.5]) judge.Add(new TraceSpan(0.0, 1.0, 1000, SegmentPart.Of(circle, half, half + 0.5), true));

            Assert.Equal(0.0, judge.Verdict().MissingLength);
        }
    }

    /// <summary>From a real drawing: the control points at both ends of a straight spline coincide, so that its speed is zero there and a start value beside
    /// its end does not converge.</summary>
    [Fact]
    public void The_foot_on_a_curve_that_stands_still_at_its_ends_is_found_from_every_guess()
    {
        Point2D top = new(-61.9305, -31.2912), low = new(-61.9305, -47.5887);
        var span = new BezierSpan([top.X, top.Y, 0.0, 1.0, top.X, top.Y, 0.0, 1.0, low.X, low.Y, 0.0, 1.0, low.X, low.Y, 0.0, 1.0]);
        foreach (var guess in (double[])[double.NaN, 0.0, double.Epsilon, 1e-18, 1e-13, 1e-9, 1e-5, 0.5, 1.0 - 1e-5, 1.0 - 1e-13, 1.0])
        {
            foreach (var below in (double[])[0.0, 0.0005, 0.01, 0.3, 8.0, 16.0])
            {
                var place = top - new Vector2D(0.0005, below); // half a count beside it
                Assert.True(span.PointAt(PerpendicularFoot.Place(span, place, guess)).DistanceTo(place) < 0.00051, FormattableString.Invariant($"from {guess}, {below} mm below the start"));
            }
        }
    }

    private static double MissingOfAll(Segment[] drawing, List<Point2D> run, double reach)
    {
        var missing = 0.0;
        foreach (var segment in drawing)
        {
            var (covered, longest) = (new CoveredParts(), segment.Length / s_tolerances.StepsFor(segment.Length));
            for (var i = 1; i < run.Count; i++) SegmentCutCover.CoverAny(segment, Segment.FromLine(run[i - 1], run[i]), reach, covered);
            missing += covered.Gaps().Sum(gap => (gap.To - gap.From) * segment.Length is var length && length >= longest ? length : 0.0);
        }

        return missing;
    }

    private static Segment[] Drawing(Random random) => [.. Enumerable.Range(0, random.Next(1, 5)).Select(_ => random.Next(2) == 0
        ? Segment.FromLine(Place(random), Place(random))
        : Segment.FromArc(new ArcSegment(Place(random), Math.Pow(10.0, (random.NextDouble() * 2.0) - 0.5), Angle.FromDegrees(random.NextDouble() * 360.0), Angle.FromDegrees((random.NextDouble() * 700.0) - 350.0))))];

    private static Point2D Place(Random random) => new(random.NextDouble() * 20.0, random.NextDouble() * 20.0);

    /// <summary>Chords along a part of a segment, sometimes beside it by about the reach, reversed, or away for a while.</summary>
    private static List<Point2D> Run(Random random, Segment along)
    {
        var (places, at, off) = (new List<Point2D>(), random.NextDouble(), 0.0);
        var step = 0.02 / along.Length * (random.Next(2) == 0 ? 1.0 : -1.0);
        for (var i = 0; i < 400; i++)
        {
            if (random.Next(60) == 0) step = -step;
            if (random.Next(25) == 0) off = random.Next(3) switch { 0 => 0.0, 1 => s_tolerances.Coverage * 2.0 * random.NextDouble(), _ => random.NextDouble() };
            at = Math.Clamp(at + (step * random.NextDouble()), 0.0, 1.0);
            places.Add(along.PointAt(at) + new Vector2D(off, off / 3.0));
        }

        return places;
    }
}
