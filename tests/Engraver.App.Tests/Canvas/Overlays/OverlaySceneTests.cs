using Avalonia;
using Engraver.App.Canvas.Marks;
using Engraver.App.Canvas.Overlays;
using Engraver.App.Canvas.Rasterising;
using Engraver.App.Canvas.Views;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.App.Tests.Canvas.Overlays;

public class OverlaySceneTests
{
    private static readonly PreparedJob s_job = JobPreparation.Prepare(
        new DrawingBuilder { Unit = LengthUnits.FromInsUnits(1)! }.Square(0.0, 0.0, 4.0).Circle(2.0, 2.0, 1.0).Line(10.0, 0.0, 12.0, 0.0).Build(), new DrawingSettings(), MotionStyle.Continuous);

    private static readonly OverlayScene s_scene = OverlayScene.From(s_job, new OverlayInputs
    {
        MoveSpeeds = [0.0, 0.5], Findings = [new Point2D(7.0, 7.0)], MachineEnvelope = new Bounds2D(-1.0, -1.0, 20.0, 20.0), WorkOrigin = new Point2D(1.0, 2.0),
    });

    [Fact]
    public void Contours_tell_inside_outside_and_open_in_drawing_units()
    {
        var kinds = s_scene.Contours.Primitives.GroupBy(primitive => primitive.Colour).ToDictionary(group => group.Key, group => group.Count());

        Assert.Equal(4, kinds[OverlayScene.ClosedOutside]);
        Assert.Equal(1, kinds[OverlayScene.ClosedInside]);
        Assert.Equal(1, kinds[OverlayScene.Open]);
        Assert.True(new Bounds2D(0.0, 0.0, 12.0, 4.0).Grown(1e-9).Contains(s_scene.Contours.Bounds));
        Assert.Equal(12.0, s_scene.Contours.Bounds.MaxX, 9);
    }

    [Fact]
    public void Rapids_go_from_the_tool_start_through_every_stroke()
    {
        Assert.Equal(3, s_scene.Rapids.Count);
        var first = s_scene.Rapids.Primitives.Single(primitive => primitive.Entity == 0);
        Assert.Equal((0.0, 0.0), (first.A, first.B));
        Assert.True(s_scene.StartMarks[0].Place.IsNear(new Point2D(first.C, first.D), 1e-9));
        var second = s_scene.Rapids.Primitives.Single(primitive => primitive.Entity == 1);
        var (end, scale) = (s_job.Toolpath.Strokes[0].End, 1.0 / 25.4);
        Assert.True(new Point2D(second.A, second.B).IsNear(new Point2D(end.X * scale, end.Y * scale), 1e-9));
        var last = s_scene.Rapids.Primitives.Single(primitive => primitive.Entity == 2);
        Assert.Contains(last.C, new[] { 10.0, 12.0 });
    }

    [Fact]
    public void Moves_are_numbered_through_the_job_and_coloured_by_speed()
    {
        var byMove = s_scene.CutPath.Primitives.OrderBy(primitive => primitive.Entity).ToList();

        Assert.Equal(s_scene.MoveCount, byMove.Count);
        Assert.Equal(Enumerable.Range(0, byMove.Count), byMove.Select(primitive => primitive.Entity));
        Assert.Equal([0, 32, 63], byMove.Take(3).Select(primitive => (int)primitive.Colour));
    }

    [Fact]
    public void Marks_number_the_strokes_and_point_the_way()
    {
        Assert.Equal([1, 2, 3], s_scene.OrderMarks.Select(mark => mark.Number));
        Assert.All(s_scene.OrderMarks, mark => Assert.Equal(1.0, mark.Direction.Length, 9));
        Assert.Equal(3, s_scene.FindingMarks.Count);
        Assert.Contains(s_scene.FindingMarks, mark => mark.Place.IsNear(new Point2D(10.0, 0.0), 1e-9));
        Assert.Equal(new Point2D(1.0, 2.0), Assert.Single(s_scene.OriginMarks).Place);
        Assert.Equal(4, s_scene.MachineEnvelope.Count);
    }

    [Fact]
    public void The_finding_under_the_cursor_is_found()
    {
        Assert.Equal(new Point2D(7.0, 7.0), s_scene.FindingNear(new Point2D(7.1, 7.0), 0.5));
        Assert.Null(s_scene.FindingNear(new Point2D(8.0, 7.0), 0.5));
    }

    [Fact]
    public void Recorded_places_are_joined_while_the_tool_is_on()
    {
        var scene = s_scene.WithMachine(new OverlayInputs { Recorded = [new(new(0.0, 0.0), 0.0, false), new(new(1.0, 0.0), 0.1, true), new(new(5.0, 5.0), 0.0, false), new(new(6.0, 5.0), 9.0, true)] });

        Assert.Equal([(0.0, 1.0, 6), (5.0, 6.0, 63)], scene.Recorded.Primitives.Select(line => (line.A, line.C, (int)line.Colour)));
        Assert.Same(s_scene.CutPath, scene.CutPath);
    }

    [Fact]
    public void Marks_that_would_cover_each_other_give_way_to_the_first_until_the_view_comes_nearer()
    {
        SceneMark[] marks = [.. Enumerable.Range(0, 100).Select(i => new SceneMark(new Point2D(i * 0.01, 0.0), MarkKind.Order, new Vector2D(1.0, 0.0), i + 1))];
        var size = new PixelSize(400, 400);

        Assert.InRange(new MarkLayer(marks, new CanvasView(new Point2D(0.5, 0.0), 0.1, size), 0xFFFFFFFF, 1.0).Count, 1, 1);
        Assert.Equal(9, new MarkLayer(marks, new CanvasView(new Point2D(0.5, 0.0), 0.0002, size), 0xFFFFFFFF, 1.0).Count);
    }

    /// <summary>The marks of very many open ends do not hide the drawing; a few marks have full size.</summary>
    /// <param name="unitsPerPixel">The marks are 1 unit apart.</param>
    [Theory]
    [InlineData(1.0, 1000, 2000, 4.0, 25.0)]
    [InlineData(0.04, 50, 300, 40.0, 200.0)]
    public void A_crowd_of_marks_leaves_the_drawing_to_be_seen(double unitsPerPixel, int fewest, int most, double leastPixels, double mostPixels)
    {
        var view = new CanvasView(new Point2D(0.0, 0.0), unitsPerPixel, new PixelSize(256, 256));
        SceneMark[] marks = [.. Enumerable.Range(0, 256 * 256).Select(i => new SceneMark(new Point2D((i % 256) - 128.0, (i / 256) - 128.0), MarkKind.Finding))];
        var layer = new MarkLayer(marks, view, 0xFFFFFFFF, 1.0);
        var tile = new PixelTile();
        tile.MoveTo(0, 0, 256, 256);
        layer.Paint(view, tile);

        Assert.InRange(layer.Count, fewest, most);
        Assert.InRange(tile.Layer.Count(pixel => pixel != 0) / (double)layer.Count, leastPixels, mostPixels); // pixels painted per mark
    }

    [Fact]
    public void Every_digit_has_strokes_inside_its_box()
    {
        for (var digit = 0; digit < 10; digit++)
        {
            var pieces = StrokeDigits.Pieces(digit).ToArray();
            Assert.InRange(pieces.Length, 2, 16);
            Assert.All(pieces, piece => Assert.True(piece is { FromX: >= 0.0 and <= 4.0, ToX: >= 0.0 and <= 4.0, FromY: >= 0.0 and <= 6.0, ToY: >= 0.0 and <= 6.0 }));
        }

        Assert.Equal((1, 3), (StrokeDigits.CountOf(0), StrokeDigits.CountOf(999)));
    }
}
