using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Core.Tests.Motion;

/// <summary>The cut part and the rest together are the whole program, and only the lead-in is in both.</summary>
public class RemainingProgramTests
{
    private const double Quantum = 1.0 / 65536.0;

    private static readonly Arbitrary<(MotionProgram Program, double Part, double Within, double LeadIn)> Cases = (
        from strokes in Gen.Choose(1, 4)
        from seed in Gen.Choose(0, int.MaxValue - 1)
        from part in Gen.Choose(0, 1000)
        from within in Gen.Choose(0, 1000)
        from leadIn in Gen.Elements(0, 0, 10, 300, 5000)
        select (Random(strokes, seed), part / 1000.0, within / 1000.0, (double)leadIn)).ToArbitrary();

    [Property]
    public Property Cut_and_rest_are_the_whole_and_overlap_by_the_lead_in() => Prop.ForAll(Cases, input =>
    {
        var (program, part, within, leadIn) = input;
        var place = PlaceAt(program, part, within);
        var rest = RemainingProgram.From(program, place, leadIn, Keep);

        var (whole, left) = (Length(program), Length(rest.Program));
        var before = CutBefore(program, place);
        var overlap = before + left - whole;
        Assert.InRange(overlap, -2.5, leadIn + RemainingProgram.WholeCountSearch + 4.5);
        Assert.Equal(program.SegmentCount, rest.SegmentsBefore + rest.Program.SegmentCount);
        Assert.Equal(program.Strokes.Count, rest.StrokesBefore + rest.Program.Strokes.Count);
        AssertOnTheWhole(program, rest);
        return true;
    });

    [Property]
    public Property A_rest_of_a_rest_is_the_rest() => Prop.ForAll(Cases, input =>
    {
        var (program, part, within, _) = input;
        var place = PlaceAt(program, part, within);
        var once = RemainingProgram.From(program, place, 0.0, Keep);
        var again = RemainingProgram.From(once.Program, default, 0.0, Keep);
        Assert.Equal(once.Program.Strokes.SelectMany(stroke => stroke.Sequences).SelectMany(sequence => sequence.Segments), again.Program.Strokes.SelectMany(stroke => stroke.Sequences).SelectMany(sequence => sequence.Segments));
        return true;
    });

    [Property]
    public Property A_position_on_the_path_is_found_again() => Prop.ForAll(Cases, input =>
    {
        var (program, part, within, _) = input;
        var place = PlaceAt(program, part, within);
        if (program.SegmentAfter(place.Segments) is not var (start, segment, _)) return true;
        var at = CountsScale.Round(new SegmentPath(start, segment).At(place.Along));
        var found = ProgramPositionFinder.Find(program, place.Segments, at, 2.5);
        Assert.InRange(CutBefore(program, found), CutBefore(program, place) - 3.5, CutBefore(program, place) + 3.5);
        return true;
    });

    [Fact]
    public void Nothing_is_left_behind_the_end_and_everything_before_the_start()
    {
        var program = Random(3, 5);
        Assert.Equal(program.Strokes, RemainingProgram.From(program, default, 100.0, Keep).Program.Strokes.Select((stroke, i) => stroke with { Sequences = program.Strokes[i].Sequences }));
        Assert.Empty(RemainingProgram.From(program, new JobPosition(program.SegmentCount, 0.0), 100.0, Keep).Program.Strokes);
    }

    [Fact]
    public void A_position_that_is_nowhere_near_counts_nothing_as_cut() =>
        Assert.Equal(new JobPosition(2, 0.0), ProgramPositionFinder.Find(Random(3, 5), 2, new CountsPoint(900_000, 900_000), 2.5));

    private static double Keep(double degrees) => Math.Round(degrees / Quantum) * Quantum;

    /// <summary>Every point of the rest is on the whole program, after the start position less its lead-in.</summary>
    private static void AssertOnTheWhole(MotionProgram program, RemainingProgram rest)
    {
        var index = rest.SegmentsBefore;
        foreach (var (start, segment) in Flat(rest.Program))
        {
            var (begin, planned, _) = program.SegmentAfter(index++)!.Value;
            var (mine, whole) = (new SegmentPath(start, segment), new SegmentPath(begin, planned));
            for (var i = 0; i <= 8; i++) Assert.InRange(whole.DistanceTo(mine.At(segment.Length * i / 8.0)), 0.0, 2.0);
            Assert.InRange(Distance(segment.End, planned.End), 0.0, 2.0);
        }
    }

    private static IEnumerable<(CountsPoint Start, VectorSegment Segment)> Flat(MotionProgram program)
    {
        foreach (var sequence in program.Strokes.SelectMany(stroke => stroke.Sequences))
        {
            var start = sequence.Start;
            foreach (var segment in sequence.Segments)
            {
                yield return (start, segment);
                start = segment.End;
            }
        }
    }

    private static double CutBefore(MotionProgram program, JobPosition place) => Flat(program).Take(place.Segments).Sum(one => one.Segment.Length) + place.Along;

    private static double Length(MotionProgram program) => Flat(program).Sum(one => one.Segment.Length);

    private static JobPosition PlaceAt(MotionProgram program, double part, double within)
    {
        var segments = (int)(part * program.SegmentCount);
        return program.SegmentAfter(segments) is var (_, segment, _) ? new JobPosition(segments, within * segment.Length) : new JobPosition(segments, 0.0);
    }

    private static double Distance(CountsPoint a, CountsPoint b) => new Point2D(a.X, a.Y).DistanceTo(new Point2D(b.X, b.Y));

    /// <summary>Strokes of lines and arcs; every arc starts exactly at its drawn start and ends on the rounded count that it predicts.</summary>
    private static MotionProgram Random(int strokes, int seed)
    {
        var random = new Random(seed);
        var all = new List<MotionStroke>();
        for (var s = 0; s < strokes; s++)
        {
            var at = new CountsPoint(random.Next(-50000, 50000), random.Next(-50000, 50000));
            var (start, sequences) = (at, new List<VectorSequence>());
            for (var q = random.Next(1, 4); q > 0; q--)
            {
                var (begin, segments) = (at, new List<VectorSegment>());
                for (var i = random.Next(1, 6); i > 0; i--)
                {
                    segments.Add(random.Next(2) == 0 ? Line(random, at) : Arc(random, at));
                    at = segments[^1].End;
                }

                sequences.Add(new VectorSequence(begin, 20000, segments));
            }

            all.Add(new MotionStroke(s, start, sequences));
        }

        return new MotionProgram(MachineProfile.Default, default, all);
    }

    private static VectorSegment Line(Random random, CountsPoint from)
    {
        var to = new CountsPoint(from.X + random.Next(1, 3000), from.Y + random.Next(-3000, 3000));
        return new VectorSegment(VectorSegmentKind.Line, to, 0, 0, 0, random.Next(100), Distance(from, to));
    }

    private static VectorSegment Arc(Random random, CountsPoint from)
    {
        var (radius, theta, delta) = (random.Next(20, 4000), Keep(random.NextDouble() * 360.0), Keep((random.NextDouble() < 0.5 ? -1.0 : 1.0) * (15.0 + (random.NextDouble() * 345.0))));
        var arc = new VectorSegment(VectorSegmentKind.Arc, default, radius, theta, delta, random.Next(100), radius * Math.Abs(delta) * Math.PI / 180.0);
        return arc with { End = CountsScale.Round(new SegmentPath(from, arc).At(arc.Length)) };
    }
}
