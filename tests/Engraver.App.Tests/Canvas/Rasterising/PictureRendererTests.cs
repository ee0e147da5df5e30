using Avalonia;
using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Flattening;
using Engraver.App.Canvas.Rasterising;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;

namespace Engraver.App.Tests.Canvas.Rasterising;

public class PictureRendererTests
{
    private static readonly CanvasScene s_scene = CanvasScene.From(RandomDrawings.Of(seed: 1, count: 400), EntityColours.From(401, entity => Core.Drawings.DrawingColour.FromCode62(1 + (entity % 6))));

    public static TheoryData<double, double, double> Views => new() { { 50.0, 50.0, 0.15 }, { 40.0, 60.0, 0.01 }, { 50.0, 50.0, 2.0 } };

    [Theory]
    [MemberData(nameof(Views))]
    public void Where_a_tile_begins_makes_no_difference(double x, double y, double unitsPerPixel)
    {
        var view = new CanvasView(new Point2D(x, y), unitsPerPixel, new PixelSize(700, 500));
        var (layers, backdrop) = (Layers(new LinePen(1.5)), Backdrop.For(view, CanvasTheme.Dark, grid: true));
        var whole = PictureRenderer.Render(layers, view, backdrop, CancellationToken.None);
        var (shifted, tile) = (new Picture(view), new PixelTile());
        for (var top = 0; top < 500; top += 101)
        {
            for (var left = 0; left < 700; left += 67) PictureRenderer.Draw(shifted, layers, backdrop, tile, left, top);
        }

        Assert.Equal(whole.Pixels, shifted.Pixels);
    }

    [Theory]
    [InlineData(50.0, 50.0, 0.15)]
    [InlineData(45.0, 55.0, 0.07)]
    public void What_is_culled_is_what_cannot_be_seen(double x, double y, double unitsPerPixel)
    {
        var view = new CanvasView(new Point2D(x, y), unitsPerPixel, new PixelSize(250, 250));
        var fast = PictureRenderer.Render([new PrimitiveLayer(s_scene.Store, [0xFFFFFFFF], new LinePen(1.0))], view, Plain(view), CancellationToken.None);

        Assert.Equal(BruteForce(view), fast.Pixels);
        Assert.Contains(fast.Pixels, pixel => pixel != CanvasTheme.Dark.Background);
    }

    [Fact]
    public void A_drawing_smaller_than_a_pixel_is_still_a_dot()
    {
        var view = new CanvasView(new Point2D(50.0, 50.0), 5000.0, new PixelSize(64, 64));

        var picture = PictureRenderer.Render(Layers(LinePen.Hairline), view, Plain(view), CancellationToken.None);

        Assert.Contains(picture.Pixels, pixel => pixel != CanvasTheme.Dark.Background);
    }

    [Fact]
    public void Only_the_entities_asked_for_are_drawn()
    {
        var view = new CanvasView(new Point2D(50.0, 50.0), 0.5, new PixelSize(300, 300));
        var only = new bool[s_scene.Drawing.Entities.Count];

        var none = PictureRenderer.Render([new PrimitiveLayer(s_scene.Store, [0xFF00FF00], LinePen.Hairline) { EntityFilter = only }], view, Plain(view), CancellationToken.None);
        only[1] = true;
        var one = PictureRenderer.Render([new PrimitiveLayer(s_scene.Store, [0xFF00FF00], LinePen.Hairline) { EntityFilter = only }], view, Plain(view), CancellationToken.None);

        Assert.All(none.Pixels, pixel => Assert.Equal(CanvasTheme.Dark.Background, pixel));
        Assert.Contains(one.Pixels, pixel => pixel != CanvasTheme.Dark.Background);
    }

    [Fact]
    public void A_level_line_is_one_sharp_row_wherever_it_falls()
    {
        var scene = CanvasScene.From(new Engraver.TestKit.DrawingBuilder().Line(-10.0, 0.1234, 10.0, 0.1234).Build());
        var view = new CanvasView(Point2D.Origin, 0.1, new PixelSize(100, 100));

        var picture = PictureRenderer.Render([new PrimitiveLayer(scene.Store, [0xFFFFFFFF], LinePen.Hairline)], view, Plain(view), CancellationToken.None);

        var column = Enumerable.Range(0, 100).Select(row => picture.Pixels[(row * 100) + 50]).ToList();
        Assert.Single(column, pixel => pixel == 0xFFFFFFFF);
        Assert.Equal(99, column.Count(pixel => pixel == CanvasTheme.Dark.Background));
    }

    [Fact]
    public void A_stop_is_heard()
    {
        var view = new CanvasView(Point2D.Origin, 1.0, new PixelSize(600, 600));

        Assert.ThrowsAny<OperationCanceledException>(() => PictureRenderer.Render(Layers(LinePen.Hairline), view, Plain(view), new CancellationToken(canceled: true)));
    }

    private static IPictureLayer[] Layers(LinePen pen) => [new PrimitiveLayer(s_scene.Store, s_scene.Colours.PaletteFor(CanvasTheme.Dark), pen)];

    private static Backdrop Plain(CanvasView view) => Backdrop.For(view, CanvasTheme.Dark, grid: false);

    /// <summary>Draws every part of the drawing in its own order, unsorted and unculled.</summary>
    private static uint[] BruteForce(CanvasView view)
    {
        var (picture, tile) = (new Picture(view), new PixelTile());
        tile.MoveTo(0, 0, view.Size.Width, view.Size.Height);
        Plain(view).Fill(picture, 0, 0, view.Size.Width, view.Size.Height);
        foreach (var primitive in s_scene.Store.Primitives.OrderBy(primitive => primitive.Entity)) Draw(tile, s_scene.Store.SegmentOf(primitive), view);
        tile.Compose(picture.Pixels, view.Size.Width);
        return picture.Pixels;
    }

    private static void Draw(PixelTile tile, Segment segment, CanvasView view)
    {
        var frame = PixelFrame.From(view);
        var chords = new ChordList();
        var all = new Bounds2D(-1e12, -1e12, 1e12, 1e12);
        if (segment.Kind == SegmentKind.Line) DrawLine(tile, segment.Line, frame);
        else if (segment.IsFreeCurve) CurveFlattener.Flatten(segment.Curve, frame, all, ref chords);
        else ArcFlattener.Flatten(frame.X(segment.Arc.Centre.X), frame.Y(segment.Arc.Centre.Y), segment.Arc.Radius * frame.Scale, ArcSpan.From(segment.Arc), all, ref chords);
        foreach (var chord in chords.Chords) LineRasteriser.Draw(tile, chord.Start.X, chord.Start.Y, chord.End.X, chord.End.Y, 0xFFFFFFFF, LinePen.Hairline);
    }

    private static void DrawLine(PixelTile tile, LineSegment line, PixelFrame frame)
    {
        var (fromX, fromY, toX, toY) = (frame.X(line.Start.X), frame.Y(line.Start.Y), frame.X(line.End.X), frame.Y(line.End.Y));
        if (line.Start.X == line.End.X) fromX = toX = Math.Floor(fromX) + 0.5;
        if (line.Start.Y == line.End.Y) fromY = toY = Math.Floor(fromY) + 0.5;
        LineRasteriser.Draw(tile, fromX, fromY, toX, toY, 0xFFFFFFFF, LinePen.Hairline);
    }
}
