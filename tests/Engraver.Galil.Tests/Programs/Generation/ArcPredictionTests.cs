using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Programs.Generation;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Galil.Tests.Programs.Generation;

public class ArcPredictionTests
{
    /// <summary>Half the diagonal of a square of one count: at the end of a sequence the machine is on whole counts.</summary>
    private const double WholeCounts = 0.7072;

    private const double OneCount = 1.0 + 1e-6;

    /// <summary>Sagitta of the chords that replace an arc when CR is not accurate enough, counts.</summary>
    private const double ChordError = 0.25;

    [Fact]
    public void A_half_circle_ends_across_its_centre()
    {
        var half = new ArcPrediction(new Point2D(15000, 15000), 5000, 0.0, 180.0);

        Assert.Equal(new Point2D(10000, 15000), half.Centre);
        Assert.Equal(new Point2D(5000, 15000), half.End);
        Assert.Equal(5000 * Math.PI, half.Length, 9);
    }

    [Fact]
    public void A_whole_turn_comes_back_to_the_very_place() =>
        Assert.Equal(new Point2D(3.25, -7.5), new ArcPrediction(new Point2D(3.25, -7.5), 1234, 12.3456, -360.0).End);

    [Fact]
    public void The_deviation_is_that_of_the_worst_place_on_the_path_not_of_its_ends()
    {
        var wanted = new ArcSegment(Point2D.Origin, 100.0, Angle.FromDegrees(0), Angle.FromDegrees(180));
        var pushedUp = new ArcPrediction(new Point2D(100.0, 2.0), 100, 0.0, 180.0);

        Assert.Equal(2.0, pushedUp.DeviationFrom(wanted), 9);
    }

    [Property]
    public Property The_deviation_is_never_less_than_a_sampled_one() =>
        Prop.ForAll(Gen.Choose(10, 2000).Four().ToArbitrary(), t =>
        {
            var (radius, theta, sweep, shift) = t;
            var wanted = new ArcSegment(Point2D.Origin, radius, Angle.FromDegrees(theta), Angle.FromDegrees((sweep % 360) + 1));
            var cut = new ArcPrediction(wanted.StartPoint + new Vector2D(shift % 7, shift % 5), radius + (shift % 3), theta + (shift % 2), wanted.Sweep.Degrees);
            var path = new ArcSegment(cut.Centre, cut.Radius, Angle.FromDegrees(cut.ThetaDegrees), Angle.FromDegrees(cut.DeltaDegrees));
            var sampled = Enumerable.Range(0, 501).Max(i => Math.Abs(path.PointAt(i / 500.0).DistanceTo(Point2D.Origin) - radius));
            return cut.DeviationFrom(wanted) >= sampled - 1e-6 && cut.DeviationFrom(wanted) <= sampled + 0.05 + (radius * 1e-4);
        });

    [Property(MaxTest = 400)]
    public Property Every_arc_is_followed_within_a_count_and_ends_within_a_count() =>
        Prop.ForAll(Drawn().ToArbitrary(), drawn =>
        {
            var (arc, profile) = drawn;
            var off = WorstOff(Toolpaths.OfStroke(Segment.FromArc(arc)), profile);
            return (off.Path <= OneCount && off.End <= OneCount).Label($"{arc}: path {off.Path}, end {off.End}");
        });

    [Property(MaxTest = 60)]
    public Property Fifty_arcs_after_each_other_do_not_add_up_their_errors() =>
        Prop.ForAll(Chain().ToArbitrary(), chain =>
        {
            var (arcs, profile) = chain;
            var off = WorstOff(Toolpaths.OfStroke([.. arcs.Select(Segment.FromArc)]), profile);
            return (off.Path <= OneCount && off.End <= OneCount).Label($"{arcs.Count} arcs: path {off.Path}, end {off.End}");
        });

    /// <summary>Largest distance of the replayed path from the drawing (less the tolerance of chords and the rounding to whole counts at stops), and of every
    /// stroke's end from its drawn end (counts).</summary>
    private static (double Path, double End) WorstOff(Toolpath toolpath, MachineProfile profile)
    {
        var program = MotionProgramGenerator.Generate(toolpath, profile, new(profile.Scale.Finer.LengthOf(ChordError), 0.0), null).Program;
        Assert.NotNull(program);
        var (path, end) = (0.0, 0.0);
        foreach (var (stroke, drawn) in program.Strokes.Zip(toolpath.Strokes))
        {
            var replay = new SegmentReplay(profile.AngleQuantumDegrees);
            foreach (var sequence in stroke.Sequences) replay.Run(sequence);
            var wanted = drawn.Moves.Select(move => profile.Scale.Exact(move.Segment.Arc)).ToList();
            var chords = stroke.Sequences.Any(sequence => sequence.Segments.Any(segment => segment.Kind == VectorSegmentKind.Line)) ? ChordError : 0.0;
            var standing = stroke.Sequences.Count > 1 ? WholeCounts : 0.0;
            path = Math.Max(path, replay.Track.Max(at => wanted[at.Entity].DistanceTo(at.Place)) - chords - standing);
            end = Math.Max(end, profile.Scale.Exact(drawn.End).DistanceTo(new Point2D(replay.X, replay.Y)));
        }

        return (path, end);
    }

    private static Gen<MachineProfile> Machine() =>
        from mirrorX in Gen.Elements(1.0, -1.0)
        from mirrorY in Gen.Elements(1.0, -1.0)
        from quantum in Gen.Elements(65536.0, 65536.0, 256.0)
        select new MachineProfile { Axes = MachineAxes.FromScale(1000.0 * mirrorX, 1000.0 * mirrorY), AngleQuantumDegrees = 1.0 / quantum };

    private static Gen<double> Between(double low, double high) => Gen.Choose(0, 1_000_000).Select(n => low + ((high - low) * n / 1e6));

    /// <summary>Radius 10 counts to 6e6 counts, evenly over the orders of magnitude.</summary>
    private static Gen<(ArcSegment Arc, MachineProfile Profile)> Drawn() =>
        from exponent in Between(1.0, Math.Log10(6e6))
        from x in Between(-100, 100)
        from y in Between(-100, 100)
        from start in Between(-360, 360)
        from sweep in Gen.OneOf(Between(-359.99, 359.99).Where(s => Math.Abs(s) > 0.01), Gen.Elements(360.0, -360.0, 90.0, -90.0, 180.0, -180.0))
        from profile in Machine()
        select (new ArcSegment(new Point2D(x, y), Math.Pow(10, exponent) / 1000.0, Angle.FromDegrees(start), Angle.FromDegrees(sweep)), profile);

    /// <summary>Up to fifty arcs of 20 counts to 200,000 counts, each starting at the end and in the direction of the previous one.</summary>
    private static Gen<(List<ArcSegment> Arcs, MachineProfile Profile)> Chain() =>
        from count in Gen.Choose(2, 50)
        from exponents in Between(1.3, 5.3).ListOf(count)
        from sweeps in Between(-200, 200).Where(s => Math.Abs(s) > 5.0).ListOf(count)
        from profile in Machine()
        select (Tangent([.. exponents], [.. sweeps]), profile);

    private static List<ArcSegment> Tangent(double[] exponents, double[] sweeps)
    {
        var arcs = new List<ArcSegment>();
        var (place, heading) = (new Point2D(1.2345, -0.6789), 17.0);
        foreach (var (exponent, sweep) in exponents.Zip(sweeps))
        {
            var radius = Math.Pow(10, exponent) / 1000.0;
            var spoke = heading - (Math.Sign(sweep) * 90.0);
            var centre = place - Vector2D.FromPolar(radius, Angle.FromDegrees(spoke));
            arcs.Add(new ArcSegment(centre, radius, Angle.FromDegrees(spoke), Angle.FromDegrees(sweep)));
            (place, heading) = (arcs[^1].EndPoint, heading + sweep);
        }

        return arcs;
    }
}
