using Engraver.App.Canvas.Flattening;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Rasterising;

/// <summary>Draws the part of a layer that a tile shows: blocks outside are skipped unread, blocks smaller than a pixel become a dot.</summary>
internal static class LayerPainter
{
    /// <summary>A block no larger than this is drawn as one short line, pixels.</summary>
    private const double DotSize = 0.75;

    public static void Paint(PictureLayer layer, CanvasView view, PixelTile tile)
    {
        var frame = PixelFrame.Of(view);
        var brush = new Brush(tile, layer, frame, Clip(view, layer.Pen));
        var store = layer.Store;
        var seen = view.WindowOf(tile.Left, tile.Top, tile.Width, tile.Height).Grown((layer.Pen.Reach + 1.0) * view.UnitsPerPixel);
        var dot = layer.Only is null ? DotSize * view.UnitsPerPixel : -1.0;
        for (var block = 0; block < store.Blocks.Length; block++)
        {
            ref readonly var box = ref store.Blocks[block];
            if (!PrimitiveStore.Overlap(box, seen)) continue;
            if (box.MaxX - box.MinX <= dot && box.MaxY - box.MinY <= dot) brush.Dot(box, store.Block(block)[0].Colour);
            else PaintBlock(store, block, seen, ref brush);
        }
    }

    /// <summary>Curves are cut off outside the whole picture, not outside the tile: their chords are then the same in every tile.</summary>
    private static Bounds2D Clip(CanvasView view, LinePen pen) => new Bounds2D(0.0, 0.0, view.Size.Width, view.Size.Height).Grown(pen.Reach + 2.0);

    private static void PaintBlock(PrimitiveStore store, int block, in Bounds2D seen, ref Brush brush)
    {
        foreach (ref readonly var primitive in store.Block(block))
        {
            if (primitive.Kind == SegmentKind.Line) brush.Line(primitive, seen);
            else if (brush.Takes(primitive) && PrimitiveStore.Overlap(store.BoundsOf(primitive), seen)) brush.Curve(primitive);
        }
    }

    private struct Brush(PixelTile tile, PictureLayer layer, PixelFrame frame, Bounds2D clip) : IChordSink
    {
        private readonly PixelFrame _frame = frame;
        private readonly Bounds2D _clip = clip;
        private readonly uint[] _palette = layer.Palette;
        private readonly bool[]? _only = layer.Only;
        private readonly LinePen _pen = layer.Pen;
        private uint _colour;

        public readonly bool Takes(in ScenePrimitive primitive) => _only is null || ((uint)primitive.Entity < (uint)_only.Length && _only[primitive.Entity]);

        public readonly void Chord(double fromX, double fromY, double toX, double toY) => LineRasteriser.Draw(tile, fromX, fromY, toX, toY, _colour, _pen);

        public void Line(in ScenePrimitive line, in Bounds2D seen)
        {
            if (!Takes(line) || IsOutside(line, seen)) return;
            _colour = ColourOf(line.Colour);
            var (fromX, fromY, toX, toY) = (_frame.X(line.A), _frame.Y(line.B), _frame.X(line.C), _frame.Y(line.D));
            if (line.A == line.C) fromX = toX = Snapped(fromX);
            if (line.B == line.D) fromY = toY = Snapped(fromY);
            Chord(fromX, fromY, toX, toY);
        }

        public void Curve(in ScenePrimitive primitive)
        {
            _colour = ColourOf(primitive.Colour);
            var store = layer.Store;
            if (primitive.Kind is SegmentKind.Arc or SegmentKind.Circle)
            {
                ArcFlattener.Flatten(_frame.X(primitive.A), _frame.Y(primitive.B), primitive.C * _frame.Scale, store.Arcs[(int)primitive.D], _clip, ref this);
            }
            else
            {
                CurveFlattener.Flatten(store.Curves[(int)primitive.A], _frame, _clip, ref this);
            }
        }

        public void Dot(in Bounds2D box, ushort colour)
        {
            _colour = ColourOf(colour);
            Chord(_frame.X(box.MinX), _frame.Y(box.MinY), _frame.X(box.MaxX), _frame.Y(box.MaxY));
        }

        private readonly uint ColourOf(ushort index) => _palette[Math.Min(index, _palette.Length - 1)];

        private static bool IsOutside(in ScenePrimitive line, in Bounds2D seen) =>
            (line.A < seen.MinX && line.C < seen.MinX) || (line.A > seen.MaxX && line.C > seen.MaxX)
            || (line.B < seen.MinY && line.D < seen.MinY) || (line.B > seen.MaxY && line.D > seen.MaxY);

        /// <summary>Level and upright lines stand on whole pixels: one sharp row instead of two grey ones.</summary>
        private readonly double Snapped(double pixel) => (int)Math.Round(_pen.Width) % 2 == 0 ? Math.Round(pixel) : Math.Floor(pixel) + 0.5;
    }
}
