using Engraver.Core.Geometry;
using Engraver.Core.Verification;

namespace Engraver.Core.Tests.Verification;

/// <summary>Runs of short chords are covered from foot to foot; what that finds is held against the exact way, chord by chord, on random runs along, across and beside random segments.</summary>
public class DrawnCoverageTests
{
    private const int Cases = 300;

    private static readonly TraceTolerances s_tolerances = TraceTolerances.Default;

    [Fact]
    public void Foot_to_foot_covers_what_the_exact_way_covers()
    {
        var covered = 0;
        for (var seed = 1; seed <= Cases; seed++)
        {
            var random = new Random(seed);
            var drawing = Drawing(random);
            var (quick, exact) = (Coverage(drawing), Coverage(drawing));
            var run = Run(random, drawing[random.Next(drawing.Length)]);
            for (var i = 1; i < run.Count; i++)
            {
                quick.AddChord(run[i - 1], run[i]);
                exact.Add(Segment.FromLine(run[i - 1], run[i]));
            }

            var (found, expected, whole) = (quick.Missing().Length, exact.Missing().Length, drawing.Sum(segment => segment.Length));
            var step = 2.0 * drawing.Max(segment => segment.Length / s_tolerances.StepsFor(segment.Length));

            Assert.True(Math.Abs(found - expected) <= step, FormattableString.Invariant($"seed {seed}: {found} of {whole} mm missing, {expected} by the exact way"));
            if (expected < whole - step) covered++;
        }

        Assert.InRange(covered, Cases / 4, Cases); // runs that cover nothing would prove nothing
    }

    /// <summary>As a real drawing has it: the control points at both ends of a straight spline coincide, so that it stands still there. The tool comes round the corner, by as much beside it as an arc's end may be, and starts from rest.</summary>
    [Fact]
    public void A_tool_that_starts_where_a_curve_stands_still_covers_it_from_its_end()
    {
        Point2D top = new(-61.9305, -31.2912), low = new(-61.9305, -47.5887);
        Segment[] drawing = [.. CurvePieces.Split([Segment.FromCurve(new RationalCurve(SegmentKind.Spline, [new BezierSpan([top.X, top.Y, 0.0, 1.0, top.X, top.Y, 0.0, 1.0, low.X, low.Y, 0.0, 1.0, low.X, low.Y, 0.0, 1.0])]))]), .. Enumerable.Repeat(Segment.FromLine(top - new Vector2D(0.1, 0.0), top), 12)]; // many curves meet there: what lies around is looked up in small steps
        var wrong = new List<string>();
        foreach (var (x, y) in from x in Enumerable.Range(-3, 7) from y in Enumerable.Range(-3, 7) select (x / 1000.0, y / 1000.0))
        {
            var coverage = Coverage(drawing);
            var corner = new Point2D(Math.Round(top.X, 3) + x, Math.Round(top.Y, 3) + y);
            for (var sample = 30; sample > 0; sample--) coverage.AddChord(Ramp(corner, -1.0, 0.0, sample), Ramp(corner, -1.0, 0.0, sample - 1));
            for (var sample = 0; sample < 80; sample++) coverage.AddChord(Ramp(corner, 0.0, -1.0, sample), Ramp(corner, 0.0, -1.0, sample + 1));
            coverage.Add(Segment.FromLine(Ramp(corner, 0.0, -1.0, 80), new Point2D(corner.X, low.Y)));

            if (coverage.Missing().Length > 0.0) wrong.Add(FormattableString.Invariant($"{x} {y}: {coverage.Missing()}"));
        }

        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
    }

    /// <summary>Counts from rest at the profile's acceleration, a sample a millisecond.</summary>
    private static Point2D Ramp(Point2D from, double x, double y, int sample) => from + (new Vector2D(x, y) * (Math.Round(0.128 * sample * sample) / 1000.0));

    private static DrawnCoverage Coverage(Segment[] drawing) => new(drawing, new SegmentIndex(drawing), s_tolerances);

    private static Segment[] Drawing(Random random) => [.. Enumerable.Range(0, random.Next(1, 5)).Select(_ => random.Next(2) == 0
        ? Segment.FromLine(Place(random), Place(random))
        : Segment.FromArc(new ArcSegment(Place(random), Math.Pow(10.0, (random.NextDouble() * 2.0) - 0.5), Angle.FromDegrees(random.NextDouble() * 360.0), Angle.FromDegrees((random.NextDouble() * 700.0) - 350.0))))];

    private static Point2D Place(Random random) => new(random.NextDouble() * 20.0, random.NextDouble() * 20.0);

    /// <summary>Chords along a part of a segment, now and then beside it by about the reach, turned back, or away for a while.</summary>
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
