using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Scenes;

/// <summary>Primitives in blocks of neighbours, each block with its box, which is the complete spatial index. Immutable, safe for all threads.</summary>
/// <remarks>A scan of a million primitives reads the boxes of 16 thousand blocks, which takes about as long as descending a tree, and costs half a byte per
/// primitive.</remarks>
internal sealed class PrimitiveStore
{
    public const int BlockSize = 64;

    internal PrimitiveStore(ScenePrimitive[] primitives, ArcSpan[] arcs, RationalCurve[] curves)
    {
        Primitives = primitives;
        Arcs = arcs;
        Curves = curves;
        Blocks = new Bounds2D[(primitives.Length + BlockSize - 1) / BlockSize];
        BlockBounds.Fill(this);
        var bounds = Bounds2D.Empty;
        foreach (var block in Blocks) bounds = bounds.Union(block);
        Bounds = bounds;
    }

    public static PrimitiveStore Empty { get; } = new([], [], []);

    public ScenePrimitive[] Primitives { get; }

    public ArcSpan[] Arcs { get; }

    public RationalCurve[] Curves { get; }

    /// <summary>Tight box of each block.</summary>
    public Bounds2D[] Blocks { get; }

    /// <summary>Tight box of all primitives.</summary>
    public Bounds2D Bounds { get; }

    public int Count => Primitives.Length;

    /// <summary>Approximate size in memory, without the curves of the drawing itself.</summary>
    public long Bytes => (Primitives.LongLength * 40) + (Arcs.LongLength * 16) + (Blocks.LongLength * 32) + (Curves.LongLength * 8);

    /// <summary>The primitives of a block.</summary>
    public ReadOnlySpan<ScenePrimitive> Block(int block) => Primitives.AsSpan(block * BlockSize, Math.Min(BlockSize, Primitives.Length - (block * BlockSize)));

    public Bounds2D BoundsOf(in ScenePrimitive primitive) => BoundsOf(primitive, Arcs, Curves);

    internal static Bounds2D BoundsOf(in ScenePrimitive primitive, ArcSpan[] arcs, RationalCurve[] curves) => primitive.Kind switch
    {
        SegmentKind.Line => new Bounds2D(Math.Min(primitive.A, primitive.C), Math.Min(primitive.B, primitive.D), Math.Max(primitive.A, primitive.C), Math.Max(primitive.B, primitive.D)),
        SegmentKind.Arc or SegmentKind.Circle => arcs[(int)primitive.D].BoundsOf(new Point2D(primitive.A, primitive.B), primitive.C),
        _ => curves[(int)primitive.A].Bounds,
    };

    /// <summary>The primitive as a segment of the drawing.</summary>
    public Segment SegmentOf(in ScenePrimitive primitive)
    {
        if (primitive.Kind == SegmentKind.Line) return Segment.FromLine(new Point2D(primitive.A, primitive.B), new Point2D(primitive.C, primitive.D));
        if (primitive.Kind is not (SegmentKind.Arc or SegmentKind.Circle)) return Segment.FromCurve(Curves[(int)primitive.A]);
        var span = Arcs[(int)primitive.D];
        var sweep = primitive.Kind == SegmentKind.Circle ? Angle.FullTurn * Math.Sign(span.Sweep) : Angle.FromRadians(span.Sweep);
        return Segment.FromArc(new ArcSegment(new Point2D(primitive.A, primitive.B), primitive.C, Angle.FromRadians(span.Start), sweep));
    }

    /// <summary>Blocks whose box overlaps or touches the box.</summary>
    public IEnumerable<int> BlocksTouching(Bounds2D box)
    {
        for (var block = 0; block < Blocks.Length; block++)
        {
            if (Overlap(Blocks[block], box)) yield return block;
        }
    }

    internal static bool Overlap(in Bounds2D a, in Bounds2D b) => a.MinX <= b.MaxX && b.MinX <= a.MaxX && a.MinY <= b.MaxY && b.MinY <= a.MaxY;
}
