using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Verification;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines.Runs;

public sealed class RunLagTests
{
    private const double Step = 0.002;

    private static readonly MotionProgram s_program = JobPreparation.Prepare(new DrawingBuilder().Line(0, 0, 40, 0).Line(40, 0, 40, 30).Circle(60, 0, 10).Build(), new DrawingSettings(), MotionStyle.Continuous).Motion.Program!;

    /// <summary>A record has few places at rest: the last one before the motion may be that at which the machine came to rest.</summary>
    [Theory]
    [InlineData(50)]
    [InlineData(1)]
    public void A_run_as_planned_has_no_lag(int placesAtRest)
    {
        var lag = RunLag.Of(s_program, Run(_ => 1.0, placesAtRest: placesAtRest))!;

        Assert.InRange(lag.Seconds, -0.01, 0.01);
        Assert.Empty(lag.Places);
    }

    /// <summary>The second line is run at half of the speed: as much time is lost as it needs, there.</summary>
    [Fact]
    public void The_time_that_a_slow_part_loses_is_found_at_its_place()
    {
        var lag = RunLag.Of(s_program, Run(place => place is { X: > 39.9, Y: > 2.0 and < 25.0 } and { X: < 41.0 } ? 0.5 : 1.0))!;
        var most = Assert.Single(lag.Places);

        Assert.Equal(1, most.Entity);
        Assert.InRange(most.Place.DistanceTo(new Point2D(40.0, 2.0)), 0.0, 0.5);
        Assert.InRange(most.Seconds, 1.1, 1.2); // 23 mm at 20 mm/s
        Assert.InRange(lag.Seconds, most.Seconds - 0.01, most.Seconds + 0.01);
        Assert.Equal((20.0, 10.0), (Math.Round(most.PlannedSpeed), Math.Round(most.Speed)));
    }

    /// <summary>A position exactly at the end of a long segment is followed by positions on a short one.</summary>
    [Fact]
    public void Positions_after_the_end_of_a_segment_are_on_the_next_one()
    {
        var program = JobPreparation.Prepare(new DrawingBuilder().Line(0, 0, 40, 0).Line(40, 0, 40, 10).Build(), new DrawingSettings { CornerToleranceMm = 0.0 }, MotionStyle.Continuous).Motion.Program!;
        List<Point2D> way = [.. Enumerable.Range(0, 41).Select(x => new Point2D(x, 0)), .. Enumerable.Range(1, 9).Select(y => new Point2D(40, y))];
        var lag = RunLag.Of(program, new RunTrace("polled", [.. way.Select((place, i) => new RunTracePlace(0.1 * i, place, true, 0.0))]))!;

        Assert.DoesNotContain(double.NaN, lag.Behind);
    }

    /// <summary>An override of the operator does not count as lag.</summary>
    [Fact]
    public void An_override_counts_as_planned()
    {
        var lag = RunLag.Of(s_program, Run(_ => 0.5, new TraceConditions(0.5, null)))!;

        Assert.InRange(lag.Seconds, -0.05, 0.05);
        Assert.Empty(lag.Places);
    }

    /// <summary>A resumed run begins in the middle of the program.</summary>
    [Fact]
    public void A_run_of_the_rest_is_compared_from_where_it_begins()
    {
        var all = Run(_ => 1.0).Places;
        var first = all.ToList().FindIndex(place => place.Place.X > 55.0);
        var lag = RunLag.Of(s_program, new RunTrace("polled", [.. all.Skip(first)]))!;

        Assert.InRange(lag.Seconds, -0.01, 0.01);
    }

    [Fact]
    public void Positions_beside_the_path_are_not_compared() => Assert.Null(RunLag.Of(s_program, new RunTrace("polled", [.. Run(_ => 1.0).Places.Select(place => place with { Place = place.Place + new Vector2D(5.0, 5.0) })])));

    /// <summary>The planned motion, by its profiles, with a factor of its speed at each place; a second of rest between the sequences.</summary>
    private static RunTrace Run(Func<Point2D, double> factorAt, TraceConditions conditions = default, int placesAtRest = 50)
    {
        var (places, seconds) = (new List<RunTracePlace>(), 0.0);
        foreach (var sequence in s_program.Strokes.SelectMany(stroke => stroke.Sequences))
        {
            var (profile, planned) = (SequenceProfile.Of(sequence, s_program.Profile), 0.0);
            for (var at = 0; at < placesAtRest; at++) places.Add(new RunTracePlace(seconds + (at * Step), At(sequence, 0.0), true, 0.0) { Conditions = conditions });
            seconds += 50 * Step;
            while (planned < profile.Seconds)
            {
                var place = At(sequence, profile.PathAt(planned));
                places.Add(new RunTracePlace(seconds, place, true, 0.0) { Conditions = conditions });
                planned += Step * factorAt(place);
                seconds += Step;
            }

            for (var at = 0; at < placesAtRest; at++) places.Add(new RunTracePlace(seconds + (at * Step), At(sequence, sequence.Length), true, 0.0) { Conditions = conditions });
            seconds += 50 * Step;
            places.Add(new RunTracePlace(seconds, places[^1].Place, false, 0.0));
            seconds += 1.0;
        }

        return new RunTrace("polled", places);
    }

    private static Point2D At(VectorSequence sequence, double path)
    {
        var start = sequence.Start;
        foreach (var segment in sequence.Segments)
        {
            if (path <= segment.Length) return Rounded(new SegmentPath(start, segment).At(path));
            path -= segment.Length;
            start = segment.End;
        }

        return Rounded(new Point2D(start.X, start.Y));
    }

    private static Point2D Rounded(Point2D counts) => s_program.Profile.Scale.ToMillimetres(Math.Round(counts.X), Math.Round(counts.Y));
}
