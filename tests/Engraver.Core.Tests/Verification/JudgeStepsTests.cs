using Engraver.Core.Geometry;
using Engraver.Core.Verification;

namespace Engraver.Core.Tests.Verification;

/// <summary>However crowded and however large a drawing is, the judge looks at few of its segments for each question: steps are counted by the index, not timed.</summary>
public class JudgeStepsTests
{
    private const int Count = 2000;

    /// <summary>Steps of a question: nodes of the tree on the way to what is near, and distances.</summary>
    private const int FewSteps = 400;

    public static TheoryData<string> Crowded => ["diagonals", "fan", "rings", "shifted arcs", "ellipses", "hatch"];

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

    [Theory]
    [MemberData(nameof(Crowded))]
    public void Few_segments_lie_along_one_of_many(string name)
    {
        var drawing = Drawing(name);
        var index = new SegmentIndex(drawing, segment => DrawnCoverage.Crossed(segment, TraceTolerances.Default));
        var (found, sum, questions) = (new List<int>(), 0, 0);
        for (var i = 0; i < drawing.Length; i += 7)
        {
            if (drawing[i].IsFreeCurve) continue;
            var path = SpanDeviation.Part(drawing[i], 0.0, 0.5);
            if (path.Kind == SegmentKind.Line) index.AlongNotAcross(path.Line, 0.004, found);
            else index.Along(path, 0.004, found);
            Assert.Contains(i, found);
            (sum, questions) = (sum + found.Count, questions + 1);
        }

        Assert.True(sum <= 100 * questions, $"{sum} segments along {questions} paths");
    }

    [Theory]
    [MemberData(nameof(Crowded))]
    public void A_judge_of_short_chords_along_crowded_segments_looks_at_few(string name)
    {
        var drawing = Drawing(name);
        var index = new SegmentIndex(drawing);
        var coverage = new DrawnCoverage(drawing, index, TraceTolerances.Default);
        for (var i = 0; i < drawing.Length; i += 7)
        {
            var before = drawing[i].PointAt(0.4);
            for (var step = 1; step <= 10; step++)
            {
                var next = drawing[i].PointAt(0.4 + (0.01 * step / drawing[i].Length));
                coverage.AddChord(before, next);
                before = next;
            }
        }

        Assert.InRange(index.Steps / (drawing.Length / 7.0), 1.0, 3 * FewSteps);
    }

    private static Segment[] Drawing(string name) => name switch
    {
        "diagonals" => Each(i => Segment.FromLine(new Point2D(i, 0), new Point2D(i + 61_000, 59_595))),
        "fan" => Each(i => Segment.FromLine(new Point2D(i, 0), new Point2D((2 * i) + 61_000, 59_595))),
        "rings" => Each(i => Segment.FromArc(new ArcSegment(default, 10 + (0.5 * i), Angle.Zero, Angle.FullTurn))),
        "shifted arcs" => Each(i => Segment.FromArc(new ArcSegment(new Point2D(0, i), 100_000, Angle.FromDegrees(20), Angle.FromDegrees(50)))),
        "ellipses" => [.. CurvePieces.Split(Ellipses())],
        "hatch" => [.. Each(i => Segment.FromLine(new Point2D(i, 0), new Point2D(i + 3000, 2950))), .. Each(i => Segment.FromLine(new Point2D(i, 3000), new Point2D(i + 3000, 0)))],
        _ => throw new ArgumentException(name, nameof(name)),
    };

    private static Segment[] Each(Func<int, Segment> segment) => [.. Enumerable.Range(0, Count).Select(segment)];

    private static Segment[] Ellipses() =>
        [.. Enumerable.Range(0, 100).Select(i => Segment.FromCurve(EllipseOf(new Point2D(0, i), new Vector2D(6000, 2000), 0.4)))];

    private static RationalCurve EllipseOf(Point2D centre, Vector2D major, double ratio) => new EllipseArc(new Vector3D(centre.X, centre.Y, 0), new Vector3D(major.X, major.Y, 0), new Vector3D(-major.Y * ratio, major.X * ratio, 0), Angle.Zero, Angle.FullTurn).ToCurve();
}
