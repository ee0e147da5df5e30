using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Drawings;

public class DrawingEditTests
{
    private static readonly Transform2D Somewhere = Transform2D.Rotate(new Point2D(1, 2), Angle.FromDegrees(30));

    [Fact]
    public void Erasing_keeps_the_others_whole_and_leaves_the_old_drawing_as_it_was()
    {
        var drawing = Mixed();
        var before = Text(drawing);
        var erased = DrawingEdit.Erase(drawing, [1, 1]);

        Assert.Equal(drawing.Entities.Count - 1, erased.Entities.Count);
        Assert.Equal("A3", erased.SourceOf(1).Handle);
        Assert.All(Enumerable.Range(0, erased.Parts.Count), part => Assert.InRange(part - erased.Entities[erased.Parts[part].Entity].FirstPart, 0, erased.Entities[erased.Parts[part].Entity].PartCount - 1));
        Assert.Equal(before, Text(drawing));
    }

    [Fact]
    public void A_transform_changes_what_is_named_and_nothing_else()
    {
        var drawing = Mixed();
        var before = Text(drawing);
        Assert.True(DrawingEdit.TryTransform(drawing, [2], Transform2D.Move(new Vector2D(5, 6)), out var moved));

        Assert.Equal(before, Text(drawing));
        Assert.Equal(drawing.Parts[0].InPlan(), moved.Parts[0].InPlan());
        Assert.Equal(drawing.Parts[drawing.Entities[2].FirstPart].A + 5, moved.Parts[moved.Entities[2].FirstPart].A);
    }

    [Fact]
    public void Lengths_scale_with_the_factor_and_arcs_stay_arcs()
    {
        var drawing = Mixed();
        DrawingEdit.TryTransform(drawing, All(drawing), Transform2D.ScaleFrom(new Point2D(3, 3), 2.5), out var scaled);
        DrawingEdit.TryTransform(scaled, All(drawing), Somewhere, out var turned);
        DrawingEdit.TryTransform(turned, All(drawing), Transform2D.MirrorAt(new Point2D(0, 0), new Point2D(3, 1)), out var mirrored);

        Assert.Equal(DrawingSummary.From(drawing).Length.Total * 2.5, DrawingSummary.From(mirrored).Length.Total, precision: 9);
        Assert.Equal(DrawingSummary.From(drawing).Primitives, DrawingSummary.From(mirrored).Primitives);
    }

    [Fact]
    public void Out_of_range_changes_nothing()
    {
        var drawing = Mixed();

        Assert.False(DrawingEdit.TryTransform(drawing, [0], Transform2D.Move(new Vector2D(1e200, 0)), out var same));
        Assert.Same(drawing, same);
        Assert.False(DrawingEdit.TryCopy(drawing, [0], Transform2D.ScaleFrom(new Point2D(1, 1), 1e200), out same));
        Assert.Same(drawing, same);
    }

    [Fact]
    public void A_copy_stands_behind_the_last_with_a_handle_of_its_own()
    {
        var drawing = Mixed();
        Assert.True(DrawingEdit.TryCopy(drawing, [3, 0], Transform2D.Move(new Vector2D(100, 0)), out var copied));

        Assert.Equal(("A7", "A8"), (copied.SourceOf(6).Handle, copied.SourceOf(7).Handle));
        Assert.Equal(4, copied.Entities[6].PartCount);
        Assert.Equal(copied.Parts[copied.Entities[3].FirstPart + 2].A + 100, copied.Parts[copied.Entities[6].FirstPart + 2].A);
        Assert.Equal(6, copied.Parts[copied.Entities[6].FirstPart].Entity);
        Assert.Equal(6, drawing.Entities.Count);
    }

    [Fact]
    public void Turning_round_twice_gives_the_same_drawing_and_once_the_same_points()
    {
        var drawing = Mixed();
        var once = DrawingEdit.Reverse(drawing, All(drawing));

        Assert.Equal(drawing.Parts[drawing.Entities[3].FirstPart].InPlan().Start, once.Parts[once.Entities[3].FirstPart + 3].InPlan().End);
        Assert.Equal(Text(drawing), Text(DrawingEdit.Reverse(once, All(drawing))));
        Assert.NotEqual(Text(drawing), Text(once));
    }

    [Fact]
    public void Ellipses_and_splines_move_turn_scale_and_mirror_place_by_place()
    {
        var drawing = Mixed();
        var maps = new[] { Transform2D.Move(new Vector2D(5, -6)), Somewhere, Transform2D.ScaleFrom(new Point2D(3, 3), 2.5), Transform2D.MirrorAt(new Point2D(0, 0), new Point2D(3, 1)) };
        foreach (var map in maps)
        {
            Assert.True(DrawingEdit.TryTransform(drawing, [4, 5], map, out var edited));
            foreach (var entity in new[] { 4, 5 })
            {
                var (before, after) = (CurveOf(drawing, entity), CurveOf(edited, entity));
                Assert.All(Enumerable.Range(0, 11), i => Assert.True(map.Apply(before.PointAt(i / 10.0)).IsNear(after.PointAt(i / 10.0), 1e-12 * 100)));
                Assert.Equal(before.PlanLength * map.Scale, after.PlanLength, 1e-9);
            }
        }
    }

    [Fact]
    public void A_copied_curve_is_another_one_and_a_reversed_one_runs_the_other_way()
    {
        var drawing = Mixed();
        Assert.True(DrawingEdit.TryCopy(drawing, [5], Transform2D.Move(new Vector2D(1, 0)), out var copied));
        var turned = DrawingEdit.Reverse(copied, [6]);

        Assert.Equal(CurveOf(drawing, 5).Start + new Vector2D(1, 0), CurveOf(copied, 6).Start);
        Assert.Equal(CurveOf(drawing, 5).Start, CurveOf(copied, 5).Start);
        Assert.Equal((CurveOf(copied, 6).End, CurveOf(copied, 6).Start), (CurveOf(turned, 6).Start, CurveOf(turned, 6).End));
        Assert.Equal(2, drawing.Curves.Count);
    }

    [Fact]
    public void A_curve_that_would_leave_the_range_changes_nothing()
    {
        var drawing = Mixed();

        Assert.False(DrawingEdit.TryTransform(drawing, [4], Transform2D.Move(new Vector2D(1e200, 0)), out var same));
        Assert.Same(drawing, same);
    }

    [Fact]
    public void Columns_of_many_chunks_share_what_is_not_touched_and_nothing_leaks_back()
    {
        var column = new GrowingColumn<int>();
        for (var i = 0; i < 10_000; i++) column.Add(i);
        var edited = column.With([(5000, -1)], [7, 8]);

        Assert.Equal((10_002, -1, 8, 4999), (edited.Count, edited[5000], edited[10_001], edited[4999]));
        Assert.Equal((10_000, 5000), (column.Count, column[5000]));
        column.Add(99);
        Assert.Equal(7, edited[10_000]);
    }

    private static Drawing Mixed() => new DrawingBuilder().Line(0, 0, 10, 0).Arc(5, 5, 4, 350, 100).Circle(20, 5, 3).Square(30, 0, 8)
        .Free(FreeCurves.Ellipse(50, 10, 9, 0.4, 25, 10, 250).ToCurve()).Free(FreeCurves.Spline(3, [new(0, 20), new(5, 30), new(9, 18), new(14, 26), new(20, 20)], [1, 2, 1, 1, 1])).Build();

    private static RationalCurve CurveOf(Drawing drawing, int entity) => drawing.SegmentOf(drawing.Parts[drawing.Entities[entity].FirstPart]).Curve;

    private static IEnumerable<int> All(Drawing drawing) => Enumerable.Range(0, drawing.Entities.Count);

    private static string Text(Drawing drawing)
    {
        using var text = new StringWriter();
        EntityTableCsv.Write(ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default)), text);
        return text.ToString();
    }
}
