using Engraver.Core.Geometry;
using Engraver.Core.Verification;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Verification;

/// <summary>The judge tests few segments for each cut, however crowded and large a drawing is: steps are counted, not timed.</summary>
public class JudgeStepsTests
{
    private const int Count = 2000;

    /// <summary>Steps of a query: nodes of the tree down to the near ones, and distances.</summary>
    private const int FewSteps = 400;

    /// <summary>For an uncut segment: a few for each of the thousands that cross it.</summary>
    private const int MaxStepsBeside = 10_000;

    /// <summary>A cut of the machine: samples while it accelerates, a span, samples while it brakes.</summary>
    private const int SamplesOfRamp = 40;

    private static readonly TraceTolerances s_rounding = UsualOptions.Trace with { CornerTolerance = 0.01, JoinTolerance = UsualOptions.JoinToleranceMm };

    public static TheoryData<string> Crowded => ["diagonals", "fan", "rings", "shifted arcs", "ellipses", "hatch"];

    public static TheoryData<string> Crossing => ["diagonals", "rings", "shifted arcs", "hatch", "star", "rays", "one line again and again", "lines half a count apart", "lines within a hair", "circles through one point", "specks"];

    [Theory]
    [MemberData(nameof(Crowded))]
    public void A_place_between_crowded_segments_is_compared_with_few(string name)
    {
        var drawing = Drawing(name);
        var index = new SegmentIndex(drawing);
        for (var i = 0; i < drawing.Length; i += 7)
        {
            var place = drawing[i].PointAt(0.41) + new Vector2D(0.1, 0.2);

            index.NearEnoughTo(place, 0.001, out var distance);

            Assert.InRange(distance, 0.0, drawing[i].DistanceTo(place));
        }

        Assert.InRange(index.Steps / (drawing.Length / 7.0), 1.0, FewSteps);
    }

    /// <summary>Where thousands of segments meet or coincide, each is compared with its own cut, and not with those of the others.</summary>
    [Theory]
    [MemberData(nameof(Crossing))]
    public void A_faithful_run_is_judged_in_few_steps_a_cut(string name)
    {
        var drawing = Drawing(name);
        var judge = new TraceJudge(drawing, UsualOptions.Trace);
        foreach (var segment in drawing) Cut(judge, segment);

        var verdict = judge.Verdict();

        Assert.Equal((0.0, 0.0), (verdict.MissingLength, verdict.ExtraLength));
        Assert.InRange(judge.Steps / (double)drawing.Length, 1.0, FewSteps + (2 * SamplesOfRamp * FewSteps / 20.0));
    }

    /// <summary>A corner for each of millions of pairs of ends would take minutes.</summary>
    [Theory]
    [MemberData(nameof(Crossing))]
    public void Corners_that_may_be_rounded_add_few_steps(string name)
    {
        var drawing = Drawing(name);
        var judge = new TraceJudge(drawing, s_rounding);
        foreach (var segment in drawing) Cut(judge, segment);

        var verdict = judge.Verdict();

        Assert.Equal((0.0, 0.0), (verdict.MissingLength, verdict.ExtraLength));
        Assert.InRange(judge.Steps / (double)drawing.Length, 1.0, MaxStepsBeside);
    }

    /// <summary>Two fans of thousands of lines, and the tool rounds from each line of one to a line of the other.</summary>
    [Fact]
    public void Thousands_of_rounded_corners_in_one_place_are_judged_in_few_steps()
    {
        Segment[] drawing = [.. Each(i => Ray(0.0005 * i)), .. Each(i => Ray(170.0 + (0.0005 * i)))];
        var judge = new TraceJudge(drawing, s_rounding);
        for (var i = 0; i < Count; i++)
        {
            var (first, second) = (drawing[i], drawing[Count + (i * 7 % Count)]);
            var contact = 0.9 * s_rounding.CornerTolerance / Math.Tan((180.0 - Math.Abs(first.StartTangent.TurnTo(second.StartTangent).Degrees)) * Math.PI / 720.0);
            var (from, to) = (first.PointAt(contact / first.Length), second.PointAt(contact / second.Length));
            judge.Add(Sample(first, 1.0, false));
            judge.Add(new TraceSpan(1, 2, 1000, Segment.FromLine(first.End, from), true));
            judge.Add(new TraceSpan(2, 3, 1000, Segment.FromArc(ArcOf(from, to, first.StartTangent)), true));
            judge.Add(new TraceSpan(3, 4, 1000, Segment.FromLine(to, second.End), true));
            judge.Add(Sample(second, 1.0, false));
        }

        var verdict = judge.Verdict();

        Assert.Equal((0.0, 0.0), (verdict.MissingLength, verdict.ExtraLength));
        Assert.InRange(verdict.MaxDeviation, 0.0, s_rounding.Deviation);
        Assert.InRange(verdict.CornerDeviation!.Value, 0.5 * s_rounding.CornerTolerance, s_rounding.CornerTolerance);
        Assert.InRange(judge.Steps / (double)Count, 1.0, 5 * MaxStepsBeside);
    }

    /// <summary>The drawing of a run that was stopped: half of it is uncut.</summary>
    [Theory]
    [MemberData(nameof(Crossing))]
    public void What_was_not_cut_is_found_in_few_steps(string name)
    {
        var drawing = Drawing(name);
        var judge = new TraceJudge(drawing, UsualOptions.Trace);
        foreach (var segment in drawing[..(drawing.Length / 2)]) Cut(judge, segment);

        judge.Verdict();

        Assert.InRange(judge.Steps / (double)drawing.Length, 1.0, MaxStepsBeside);
    }

    /// <summary>Along a segment like the machine, samples rounded to counts.</summary>
    private static void Cut(TraceJudge judge, Segment segment)
    {
        var ramp = Math.Min(0.3, 1.0 / segment.Length);
        judge.Add(Sample(segment, 0.0, false));
        for (var i = 0; i <= SamplesOfRamp; i++) judge.Add(Sample(segment, ramp * i * i / SamplesOfRamp / SamplesOfRamp, true));
        judge.Add(new TraceSpan(1, 2, 1000, SegmentPart.Of(segment, ramp, 1.0 - ramp), true));
        for (var i = SamplesOfRamp; i >= 0; i--) judge.Add(Sample(segment, 1.0 - (ramp * i * i / SamplesOfRamp / SamplesOfRamp), true));
        judge.Add(Sample(segment, 1.0, false));
    }

    private static TraceSample Sample(in Segment segment, double fraction, bool isCutting)
    {
        var place = segment.PointAt(fraction);
        return new TraceSample(0, Math.Round(place.X, 3), Math.Round(place.Y, 3), isCutting);
    }

    private static Segment[] Drawing(string name) => name switch
    {
        "diagonals" => Each(i => Segment.FromLine(new Point2D(i, 0), new Point2D(i + 61_000, 59_595))),
        "fan" => Each(i => Segment.FromLine(new Point2D(i, 0), new Point2D((2 * i) + 61_000, 59_595))),
        "rings" => Each(i => Segment.FromArc(new ArcSegment(default, 10 + (0.5 * i), Angle.Zero, Angle.FromDegrees(170)))),
        "shifted arcs" => Each(i => Segment.FromArc(new ArcSegment(new Point2D(0, i), 100_000, Angle.FromDegrees(20), Angle.FromDegrees(50)))),
        "ellipses" => [.. CurvePieces.Split(Ellipses())],
        "hatch" => [.. Each(i => Segment.FromLine(new Point2D(i, 0), new Point2D(i + 3000, 2950))), .. Each(i => Segment.FromLine(new Point2D(i, 3000), new Point2D(i + 3000, 0)))],
        "star" => Each(i => Segment.FromLine(default, new Point2D(0, 0) + (Direction(i) * 500.0))),
        "rays" => Each(i => Segment.FromLine(default, new Point2D(1000, 0.05 * i))),
        "one line again and again" => Each(_ => Segment.FromLine(default, new Point2D(300, 100))),
        "lines half a count apart" => Each(i => Segment.FromLine(new Point2D(i * 0.0005, 0), new Point2D((i * 0.0005) + 700, 650))),
        "lines within a hair" => Each(i => Segment.FromLine(new Point2D(i * 7 % 50 * 0.001, i * 11 % 50 * 0.001), new Point2D(1000 + (i * 13 % 50 * 0.001), 700 + (i * 17 % 50 * 0.001)))),
        "circles through one point" => Each(i => Segment.FromArc(new ArcSegment(new Point2D(0, 0) + (Direction(i) * 100.0), 100, Angle.FromDegrees(i * 360.0 / Count), Angle.FromDegrees(170)))),
        "specks" => Each(i => Segment.FromLine(Speck(i), Speck(i) + (Direction(i * 7) * 0.01))),
        _ => throw new ArgumentException(name, nameof(name)),
    };

    private static Segment Ray(double degrees) => Segment.FromLine(default, default(Point2D) + Vector2D.FromPolar(20.0, Angle.FromDegrees(degrees)));

    /// <summary>The arc that arrives from the first place against a direction and leaves to the second.</summary>
    private static ArcSegment ArcOf(Point2D from, Point2D to, Vector2D leaving)
    {
        var (chord, along) = (to - from, -leaving);
        var sweep = 2.0 * along.TurnTo(chord).Radians;
        var radius = chord.Length / (2.0 * Math.Abs(Math.Sin(sweep / 2.0)));
        var centre = from + (new Vector2D(-along.Y, along.X) * (radius * Math.Sign(sweep)));
        return new ArcSegment(centre, radius, (from - centre).Direction, Angle.FromRadians(sweep));
    }

    private static Point2D Speck(int i) => new(i * 37 % 101 * 0.0022, i * 53 % 103 * 0.0022);

    private static Vector2D Direction(int i) => new(Math.Cos(i * 2.0 * Math.PI / Count), Math.Sin(i * 2.0 * Math.PI / Count));

    private static Segment[] Each(Func<int, Segment> segment) => [.. Enumerable.Range(0, Count).Select(segment)];

    private static Segment[] Ellipses() =>
        [.. Enumerable.Range(0, 100).Select(i => Segment.FromCurve(EllipseOf(new Point2D(0, i), new Vector2D(6000, 2000), 0.4)))];

    private static RationalCurve EllipseOf(Point2D centre, Vector2D major, double ratio) => new EllipseArc(new Vector3D(centre.X, centre.Y, 0), new Vector3D(major.X, major.Y, 0), new Vector3D(-major.Y * ratio, major.X * ratio, 0), Angle.Zero, Angle.FullTurn).ToCurve();
}
