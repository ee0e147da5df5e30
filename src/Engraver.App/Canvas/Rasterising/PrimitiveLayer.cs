using Engraver.App.Canvas.Flattening;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Rasterising;

/// <summary>Primitives with their colours and pen: blocks outside the tile are skipped without being read, blocks smaller than a pixel become a
/// dot.</summary>
/// <param name="palette">0xAARRGGBB for each palette index; a larger index takes the last.</param>
/// <param name="pen">Pixels of the screen.</param>
internal sealed class PrimitiveLayer(PrimitiveStore store, uint[] palette, LinePen pen) : IPictureLayer
{
    /// <summary>A block of at most this size is drawn as one short line, pixels.</summary>
    private const double DotSize = 0.75;

    /// <summary>Only entities with the value true are drawn (by entity index; entities beyond the array are not drawn); null: all.</summary>
    public bool[]? EntityFilter { get; init; }

    /// <summary>Entities from this one on take the last colour of the palette (remaining), those before it the first (engraved). Null: every primitive has
    /// its own colour.</summary>
    public int? FirstRemaining { get; init; }

    private LinePen Pen => pen;

    private PrimitiveStore Store => store;

    public void Paint(CanvasView view, PixelTile tile)
    {
        var brush = new PrimitivePainter(tile, this, PixelFrame.From(view), Clip(view));
        var seen = view.WindowOf(tile.Left, tile.Top, tile.Width, tile.Height).Grown((pen.Reach + 1.0) * view.UnitsPerPixel);
        var dot = EntityFilter is null && FirstRemaining is null && !pen.IsDashed ? DotSize * view.UnitsPerPixel : -1.0;
        for (var block = 0; block < store.Blocks.Length; block++)
        {
            ref readonly var box = ref store.Blocks[block];
            if (!PrimitiveStore.Overlap(box, seen)) continue;
            if (box.MaxX - box.MinX <= dot && box.MaxY - box.MinY <= dot) brush.Dot(box, store.Block(block)[0]);
            else PaintBlock(block, seen, ref brush);
        }
    }

    /// <summary>Curves are clipped outside the whole picture, not outside the tile, so that their chords are the same in every tile.</summary>
    private Bounds2D Clip(CanvasView view) => new Bounds2D(0.0, 0.0, view.Size.Width, view.Size.Height).Grown(pen.Reach + 2.0);

    private void PaintBlock(int block, in Bounds2D seen, ref PrimitivePainter brush)
    {
        foreach (ref readonly var primitive in store.Block(block))
        {
            if (primitive.Kind == SegmentKind.Line) brush.Line(primitive, seen);
            else if (brush.Includes(primitive) && PrimitiveStore.Overlap(store.BoundsOf(primitive), seen)) brush.Curve(primitive);
        }
    }

    private uint ColourOf(in ScenePrimitive primitive) =>
        FirstRemaining is { } done ? (primitive.Entity < done ? palette[0] : palette[^1]) : palette[Math.Min(primitive.Colour, palette.Length - 1)];

    private struct PrimitivePainter(PixelTile tile, PrimitiveLayer layer, PixelFrame frame, Bounds2D clip) : IChordSink
    {
        private readonly PixelFrame _frame = frame;
        private readonly Bounds2D _clip = clip;
        private readonly bool[]? _entityFilter = layer.EntityFilter;
        private readonly LinePen _pen = layer.Pen;
        private uint _colour;

        public readonly bool Includes(in ScenePrimitive primitive) => _entityFilter is null || ((uint)primitive.Entity < (uint)_entityFilter.Length && _entityFilter[primitive.Entity]);

        public readonly void Chord(double fromX, double fromY, double toX, double toY) => LineRasteriser.Draw(tile, fromX, fromY, toX, toY, _colour, _pen);

        public void Line(in ScenePrimitive line, in Bounds2D seen)
        {
            if (!Includes(line) || IsOutside(line, seen)) return;
            _colour = layer.ColourOf(line);
            var (fromX, fromY, toX, toY) = (_frame.X(line.A), _frame.Y(line.B), _frame.X(line.C), _frame.Y(line.D));
            if (line.A == line.C) fromX = toX = Snapped(fromX);
            if (line.B == line.D) fromY = toY = Snapped(fromY);
            Chord(fromX, fromY, toX, toY);
        }

        public void Curve(in ScenePrimitive primitive)
        {
            _colour = layer.ColourOf(primitive);
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

        public void Dot(in Bounds2D box, in ScenePrimitive first)
        {
            _colour = layer.ColourOf(first);
            Chord(_frame.X(box.MinX), _frame.Y(box.MinY), _frame.X(box.MaxX), _frame.Y(box.MaxY));
        }

        private static bool IsOutside(in ScenePrimitive line, in Bounds2D seen) =>
            (line.A < seen.MinX && line.C < seen.MinX) || (line.A > seen.MaxX && line.C > seen.MaxX)
            || (line.B < seen.MinY && line.D < seen.MinY) || (line.B > seen.MaxY && line.D > seen.MaxY);

        /// <summary>Horizontal and vertical lines are moved to whole pixels: one sharp row instead of two grey ones.</summary>
        private readonly double Snapped(double pixel) => (int)Math.Round(_pen.Width) % 2 == 0 ? Math.Round(pixel) : Math.Floor(pixel) + 0.5;
    }
}
