using Engraver.App.Canvas.Colours;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Scenes;

/// <summary>The visible parts of a drawing as primitives, on all cores: each core counts its range, then writes it.</summary>
internal static class DrawingPrimitives
{
    public static PrimitiveStore Create(Drawing drawing, EntityColours colours)
    {
        var ranges = CoreRanges.Split(drawing.Parts.Count);
        var counts = new (int Parts, int Arcs)[ranges.Length];
        Parallel.For(0, ranges.Length, core => counts[core] = Count(drawing, ranges[core]));
        var primitives = GC.AllocateUninitializedArray<ScenePrimitive>(counts.Sum(count => count.Parts));
        var arcs = new ArcSpan[counts.Sum(count => count.Arcs)];
        Parallel.For(0, ranges.Length, core => Write(drawing, colours, ranges[core], primitives, counts.Take(core).Sum(c => c.Parts), arcs, counts.Take(core).Sum(c => c.Arcs)));
        return PrimitiveStoreBuilder.Sorted(primitives, arcs, [.. drawing.Curves]);
    }

    public static bool IsVisible(Drawing drawing, int entity)
    {
        ref readonly var row = ref drawing.Entities[entity];
        return !row.Hidden && drawing.Layers[row.Layer] is { On: true, Frozen: false };
    }

    private static (int Parts, int Arcs) Count(Drawing drawing, (int From, int To) range)
    {
        var (parts, arcs) = (0, 0);
        for (var i = range.From; i < range.To; i++)
        {
            ref readonly var part = ref drawing.Parts[i];
            if (!IsVisible(drawing, part.Entity)) continue;
            parts++;
            if (IsArc(part.Kind)) arcs++;
        }

        return (parts, arcs);
    }

    private static void Write(Drawing drawing, EntityColours colours, (int From, int To) range, ScenePrimitive[] primitives, int next, ArcSpan[] arcs, int nextArc)
    {
        for (var i = range.From; i < range.To; i++)
        {
            ref readonly var part = ref drawing.Parts[i];
            if (!IsVisible(drawing, part.Entity)) continue;
            if (IsArc(part.Kind)) arcs[nextArc] = new ArcSpan(Angle.FromDegrees(part.E).Radians, Angle.FromDegrees(part.F).Radians);
            primitives[next++] = PrimitiveOf(part, colours[part.Entity], nextArc);
            if (IsArc(part.Kind)) nextArc++;
        }
    }

    private static ScenePrimitive PrimitiveOf(in DrawingPart part, ushort colour, int arc) => part.Kind switch
    {
        SegmentKind.Line => new ScenePrimitive { A = part.A, B = part.B, C = part.D, D = part.E, Entity = part.Entity, Colour = colour, Kind = SegmentKind.Line },
        SegmentKind.Arc or SegmentKind.Circle => new ScenePrimitive { A = part.A, B = part.B, C = part.D, D = arc, Entity = part.Entity, Colour = colour, Kind = part.Kind },
        _ => new ScenePrimitive { A = part.CurveIndex, Entity = part.Entity, Colour = colour, Kind = part.Kind },
    };

    private static bool IsArc(SegmentKind kind) => kind is SegmentKind.Arc or SegmentKind.Circle;
}
