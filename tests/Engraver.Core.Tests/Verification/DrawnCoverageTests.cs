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

    /// <summary>As a real drawing has it: the control points at both ends of a straight spline coincide, so that it stands still there and a guess beside its end leads nowhere.</summary>
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
                Assert.True(span.PointAt(FootOf.Place(span, place, guess)).DistanceTo(place) < 0.00051, FormattableString.Invariant($"from {guess}, {below} mm below the start"));
            }
        }
    }

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
