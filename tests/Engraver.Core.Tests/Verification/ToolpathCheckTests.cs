using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Verification;

/// <summary>Toolpaths as planned pass; damaged ones are found, with the entity.</summary>
public class ToolpathCheckTests
{
    private const double MaxError = 0.001;

    [Fact]
    public void A_toolpath_as_planned_is_right()
    {
        Assert.Empty(Check(Planned(Mixed())));
        foreach (var drawn in DrawnCurves.Known.Concat(DrawnCurves.Random(seed: 21, count: TestExtent.IsFull ? 120 : 12))) Assert.True(Check(Planned(Of(drawn.Curve))) is [], $"{drawn}: {Text(Planned(Of(drawn.Curve)))}");
        foreach (var size in new[] { 0.01, 1e4, 1e7 })
        {
            foreach (var drawn in DrawnCurves.Random(seed: 22, count: TestExtent.IsFull ? 12 : 4, size)) Assert.True(Check(Planned(Of(drawn.Curve))) is [], $"{drawn} of {size}: {Text(Planned(Of(drawn.Curve)))}");
        }
    }

    [Fact]
    public void What_is_left_out_or_bridged_on_purpose_is_right()
    {
        var ring = Enumerable.Range(0, 90).Select(i => new Point2D(200 + (10 * Math.Cos(i * Math.PI / 45)), 10 * Math.Sin(i * Math.PI / 45))).ToArray();
        var builder = new DrawingBuilder().Line(0, 0, 20, 0).Line(20, 0, 0, 0.0004).Line(20.004, 0, 30, 0).Arc(50, 0, 5, 10, 200).Arc(50, 0.0005, 5, 10, 200).Circle(80, 0, 5).Circle(80.0003, 0, 5);
        for (var i = 0; i < ring.Length; i++) builder.Line(ring[i].X, ring[i].Y, ring[(i + 1) % ring.Length].X, ring[(i + 1) % ring.Length].Y);
        var curve = FreeCurves.Spline(3, [new(100, 0), new(110, 20), new(120, -20), new(130, 0)], [1, 1, 1, 1]);
        var drawing = builder.Free(curve).Free(curve.Reversed()).Build();

        Assert.Empty(Check(Planned(drawing)));
        var recovered = Planned(drawing, UsualOptions.Sequencing with { ArcTolerance = 0.01 });
        Assert.Contains(recovered.Path.Strokes, stroke => stroke.Moves is [{ Segment.Kind: SegmentKind.Circle, Segment.Arc.Radius: > 9.9 }]);
        Assert.Empty(ToolpathCheck.Findings(recovered.Drawn, recovered.Path, new ToolpathTolerances(0.01, 0.01, ArcsRecovered: true), drawing.SourceOf));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void A_stroke_that_is_moved_is_beside_its_entity_and_the_entity_is_missing(int entity)
    {
        var (drawn, path, drawing) = Planned(Mixed());
        var spoiled = Change(path, move => move.EntityIndex == entity ? move with { Segment = Moved(move.Segment, new Vector2D(0.003, 0.004)) } : move);

        var found = ToolpathCheck.Findings(drawn, spoiled, new ToolpathTolerances(MaxError, 0.01, false), drawing.SourceOf);

        Assert.All(found, finding => Assert.Equal(drawing.SourceOf(entity), finding.Source));
        Assert.Equal(["VER0020", "VER0021"], found.Select(finding => finding.Id).Order());
    }

    [Fact]
    public void Each_move_that_is_left_out_is_missing()
    {
        var (drawn, path, drawing) = Planned(Mixed());
        var moves = path.Strokes.SelectMany(stroke => stroke.Moves).ToArray();
        Assert.InRange(moves.Length, 20, 1000);
        foreach (var left in moves)
        {
            var spoiled = new Toolpath(path.ToolStart, [.. path.Strokes.Select(stroke => stroke with { Moves = [.. stroke.Moves.Where(move => move != left)] }).Where(stroke => stroke.Moves.Count > 0)]);
            var found = ToolpathCheck.Findings(drawn, spoiled, new ToolpathTolerances(MaxError, 0.01, false), drawing.SourceOf);
            Assert.Contains(found, finding => finding.Id == "VER0021" && finding.Source == drawing.SourceOf(left.EntityIndex));
        }
    }

    [Fact]
    public void An_extra_move_is_found_beside_the_drawing_and_on_it()
    {
        var (drawn, path, drawing) = Planned(Mixed());
        var elsewhere = new StrokeMove(Segment.FromLine(new Point2D(0, 50), new Point2D(1, 50)), 1);
        StrokeMove[] again = [.. path.Strokes.SelectMany(stroke => stroke.Moves).Where(move => move.EntityIndex == 1)];
        StrokeMove[] curveAgain = [.. path.Strokes.SelectMany(stroke => stroke.Moves).Where(move => move.EntityIndex == 3)];
        foreach (StrokeMove[] extra in new[] { [elsewhere], again, curveAgain })
        {
            var spoiled = path with { Strokes = [.. path.Strokes, new ToolpathStroke(path.Strokes.Count, false, extra)] };
            var found = Assert.Single(ToolpathCheck.Findings(drawn, spoiled, new ToolpathTolerances(MaxError, 0.01, false), drawing.SourceOf));
            Assert.Equal(("VER0022", drawing.SourceOf(extra[0].EntityIndex)), (found.Id, found.Source));
        }
    }

    [Fact]
    public void A_jump_within_a_stroke_is_cut_and_not_drawn()
    {
        var (drawn, path, drawing) = Planned(new DrawingBuilder().Line(0, 0, 20, 0).Line(0, 5, 20, 5).Build());
        var joined = new Toolpath(path.ToolStart, [new ToolpathStroke(0, false, [.. path.Strokes.SelectMany(stroke => stroke.Moves)])]);

        var found = Assert.Single(ToolpathCheck.Findings(drawn, joined, new ToolpathTolerances(MaxError, 0.01, false), drawing.SourceOf));

        Assert.Equal("VER0022", found.Id);
        Assert.StartsWith("For the entity, the toolpath cuts 5 mm", found.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void An_arc_of_a_random_curve_that_is_moved_by_five_counts_is_found()
    {
        foreach (var drawn in DrawnCurves.Random(seed: 23, count: 24))
        {
            var (table, path, drawing) = Planned(Of(drawn.Curve));
            var middle = path.Strokes[0].Moves[path.Strokes[0].Moves.Count / 2];
            if (middle.Segment.Length < 0.05 || drawn.Name.StartsWith("ellipse", StringComparison.Ordinal)) continue;
            var bent = Change(path, move => move == middle ? move with { Segment = Moved(move.Segment, new Vector2D(0.0035, 0.0035)) } : move);
            Assert.True(ToolpathCheck.Findings(table, bent, new ToolpathTolerances(MaxError, 0.01, false), drawing.SourceOf).Count > 0 || IsCoveredTwice(drawn, middle.Segment), $"{drawn}");
        }
    }

    /// <summary>The damaged piece was moved along itself, or another part of the curve is at its new position.</summary>
    /// <summary>Splines that cross one another everywhere: an arc is compared only with its own spline, in steps that do not grow with their number.</summary>
    [Fact]
    public void An_arc_is_held_against_its_own_curve_however_many_cross_it()
    {
        const int Curves = 150;
        const int FewSteps = 40;
        var random = new Random(11);
        var builder = new DrawingBuilder();
        for (var i = 0; i < Curves; i++) builder.Free(FreeCurves.Spline(3, [.. Enumerable.Range(0, 8).Select(_ => new Point2D(300 * random.NextDouble(), 300 * random.NextDouble()))], [1, 1, 1, 1, 1, 1, 1, 1]));
        var planned = Planned(builder.Build());
        var match = DrawnMatch.From(planned.Drawn, planned.Path, (in _, in _) => { });
        var drawing = new RepresentedRows(match.Rows, new ToolpathTolerances(MaxError, 0.01, ArcsRecovered: false));

        Assert.All(match.Moves, move => Assert.True(drawing.MaxDistance(move) is var stray && stray.Distance <= stray.Allowed));

        Assert.InRange(drawing.Steps / (double)match.Moves.Count, 9.0, 9.0 * FewSteps);
    }

    private static bool IsCoveredTwice(DrawnCurve drawn, Segment segment)
    {
        var moved = Moved(segment, new Vector2D(0.0035, 0.0035));
        return Enumerable.Range(0, 9).All(i => drawn.DistanceFrom(moved.PointAt(i / 8.0)) < 0.0012);
    }

    /// <summary>A line, an arc, a circle, a spline and an ellipse.</summary>
    private static Drawing Mixed() => new DrawingBuilder()
        .Line(0, 0, 20, 0).Arc(40, 0, 5, 10, 200).Circle(60, 0, 5)
        .Free(FreeCurves.Spline(3, [new(100, 0), new(110, 20), new(120, -20), new(130, 0), new(140, 30)], [1, 1, 1, 1, 1]))
        .Free(FreeCurves.Ellipse(200, 0, 20, 0.4, 10, 0, 360).ToCurve()).Build();

    private static Drawing Of(RationalCurve curve) => new DrawingBuilder().Free(curve).Build();

    private static (EntityTable Drawn, Toolpath Path, Drawing Drawing) Planned(Drawing drawing, SequencingOptions? options = null)
    {
        var drawn = ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default));
        return (drawn, ToolpathPlanner.Plan(Sequencer.Sequence(drawn, drawing, options ?? UsualOptions.Sequencing), default, MaxError), drawing);
    }

    private static IReadOnlyList<Diagnostic> Check((EntityTable Drawn, Toolpath Path, Drawing Drawing) planned) =>
        ToolpathCheck.Findings(planned.Drawn, planned.Path, new ToolpathTolerances(MaxError, 0.01, ArcsRecovered: false), planned.Drawing.SourceOf);

    private static string Text((EntityTable Drawn, Toolpath Path, Drawing Drawing) planned) => string.Join("; ", Check(planned).Select(found => found.Sentence));

    private static Toolpath Change(Toolpath path, Func<StrokeMove, StrokeMove> change) =>
        path with { Strokes = [.. path.Strokes.Select(stroke => stroke with { Moves = [.. stroke.Moves.Select(change)] })] };

    private static Segment Moved(Segment segment, Vector2D by) => segment.Kind == SegmentKind.Line
        ? Segment.FromLine(segment.Start + by, segment.End + by)
        : Segment.FromArc(segment.Arc with { Centre = segment.Arc.Centre + by }, segment.Start + by, segment.End + by);
}
