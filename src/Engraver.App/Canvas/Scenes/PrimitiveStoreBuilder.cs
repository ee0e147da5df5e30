using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Scenes;

/// <summary>Collects primitives in drawing order and creates their store. For small scenes and overlays; <see cref="DrawingPrimitives"/> collects the parts
/// of a drawing faster.</summary>
internal sealed class PrimitiveStoreBuilder
{
    private readonly List<ScenePrimitive> _primitives = [];
    private readonly List<ArcSpan> _arcs = [];
    private readonly List<RationalCurve> _curves = [];

    public int Count => _primitives.Count;

    public void Add(Segment segment, int entity, ushort colour)
    {
        if (segment.Kind == SegmentKind.Line) _primitives.Add(ScenePrimitive.Line(segment.Start, segment.End, entity, colour));
        else if (segment.IsFreeCurve) AddCurve(segment.Curve, entity, colour);
        else AddArc(segment, entity, colour);
    }

    public PrimitiveStore Build() => Sorted([.. _primitives], [.. _arcs], [.. _curves]);

    /// <summary>The store of primitives in any order; the array is not kept.</summary>
    internal static PrimitiveStore Sorted(ScenePrimitive[] drawn, ArcSpan[] arcs, RationalCurve[] curves)
    {
        if (drawn.Length <= PrimitiveStore.BlockSize) return new PrimitiveStore(drawn, arcs, curves);
        var boxes = GC.AllocateUninitializedArray<Bounds2D>(drawn.Length);
        Parallel.ForEach(CoreRanges.Split(drawn.Length), range =>
        {
            for (var i = range.From; i < range.To; i++) boxes[i] = PrimitiveStore.BoundsOf(drawn[i], arcs, curves);
        });
        var order = MortonOrder.Sort(boxes);
        var sorted = GC.AllocateUninitializedArray<ScenePrimitive>(drawn.Length);
        Parallel.ForEach(CoreRanges.Split(drawn.Length), range =>
        {
            for (var i = range.From; i < range.To; i++) sorted[i] = drawn[order[i]];
        });
        return new PrimitiveStore(sorted, arcs, curves);
    }

    private void AddArc(Segment segment, int entity, ushort colour)
    {
        var arc = segment.Arc;
        _primitives.Add(new ScenePrimitive { A = arc.Centre.X, B = arc.Centre.Y, C = arc.Radius, D = _arcs.Count, Entity = entity, Colour = colour, Kind = segment.Kind });
        _arcs.Add(ArcSpan.From(arc));
    }

    private void AddCurve(RationalCurve curve, int entity, ushort colour)
    {
        _primitives.Add(new ScenePrimitive { A = _curves.Count, Entity = entity, Colour = colour, Kind = curve.Kind });
        _curves.Add(curve);
    }
}

/// <summary>Divides a range of numbers into as many equal ranges as there are cores.</summary>
internal static class CoreRanges
{
    public static (int From, int To)[] Split(int count)
    {
        var cores = Math.Max(1, Environment.ProcessorCount);
        var ranges = new (int From, int To)[cores];
        for (var core = 0; core < cores; core++) ranges[core] = ((int)((long)count * core / cores), (int)((long)count * (core + 1) / cores));
        return ranges;
    }
}
