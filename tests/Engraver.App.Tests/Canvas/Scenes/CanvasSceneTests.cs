using Engraver.App.Canvas.Scenes;
using Engraver.Benchmarks.Canvas;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.App.Tests.Canvas.Scenes;

public class CanvasSceneTests
{
    [Fact]
    public void Every_visible_part_is_there_once_with_its_own_geometry()
    {
        var drawing = RandomDrawings.Of(seed: 3, count: 500);
        var scene = CanvasScene.From(drawing);

        var expected = DrawingPick.Visible(drawing).SelectMany(entity => DrawingPick.Segments(drawing, entity).Select(segment => (entity, Fingerprint(segment)))).Order();
        var found = scene.Store.Primitives.Select(primitive => (primitive.Entity, Fingerprint(scene.Store.SegmentOf(primitive)))).Order();

        Assert.Equal(expected, found);
    }

    [Fact]
    public void Each_block_lies_in_its_box_and_the_extents_are_tight()
    {
        var drawing = RandomDrawings.Of(seed: 4, count: 500);
        var store = CanvasScene.From(drawing).Store;

        for (var block = 0; block < store.Blocks.Length; block++)
        {
            var box = store.Blocks[block];
            Assert.All(store.Block(block).ToArray(), primitive => Assert.True(box.Contains(store.BoundsOf(primitive))));
        }

        var exact = DrawingPick.BoundsOf(drawing, DrawingPick.Visible(drawing));
        Assert.True(exact.Grown(1e-9).Contains(store.Bounds) && store.Bounds.Grown(1e-9).Contains(exact));
    }

    [Fact]
    public void A_stray_far_away_leaves_the_other_blocks_small()
    {
        var (random, drawing) = (new Random(5), new DrawingBuilder().Line(1e9, 1e9, 1e9 + 1.0, 1e9));
        for (var i = 0; i < 5000; i++)
        {
            var (x, y) = (random.NextDouble() * 100.0, random.NextDouble() * 100.0);
            drawing.Line(x, y, x + 0.1, y);
        }

        var blocks = CanvasScene.From(drawing.Build()).Store.Blocks.Where(box => box.MaxX < 1000.0).ToList();

        Assert.InRange(blocks.Count, 70, 79);
        Assert.InRange(blocks.Sum(box => box.Width * box.Height), 0.0, 4.0 * 100.0 * 100.0);
    }

    [Fact]
    public void Hidden_layers_are_not_in_the_scene_and_an_empty_drawing_is_an_empty_scene()
    {
        var drawing = RandomDrawings.Of(seed: 6, count: 10);

        Assert.DoesNotContain(CanvasScene.From(drawing).Store.Primitives, primitive => drawing.Layers[drawing.Entities[primitive.Entity].Layer].Frozen);
        Assert.True(CanvasScene.From(new DrawingBuilder().Build()).Extents.IsEmpty);
    }

    [Fact]
    public void The_benchmark_sheet_has_the_number_of_segments_asked_for() => Assert.Equal(1234, CanvasScene.From(BenchmarkDrawing.Create(1234)).PrimitiveCount);

    private static (double, double, double, double) Fingerprint(Segment segment) =>
        (Math.Round(segment.Start.X, 6), Math.Round(segment.Start.Y, 6), Math.Round(segment.PointAt(0.3).X, 6), Math.Round(segment.PointAt(0.3).Y, 6));
}
