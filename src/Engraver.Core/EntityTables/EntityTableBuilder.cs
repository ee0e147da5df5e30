using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.EntityTables;

/// <summary>Converts a drawing in its own unit to an entity table in millimetres.</summary>
public static class EntityTableBuilder
{
    /// <summary>One row per directed segment of the selected layers, in file order and as drawn; polylines are divided into their parts (paper 001, section
    /// 3.3).</summary>
    /// <returns>Lines, ellipses and splines complete; arcs and circles with slots 7 to 12 only (analysis fills the rest). Slot 15 is already set for parts that
    /// have no drawn angles of their own to compute it from (polyline bulges, ellipses that are circles) and for parts drawn clockwise (mirrored
    /// blocks).</returns>
    public static EntityTable Build(Drawing drawing, LayerSelection selection)
    {
        var taken = selection.Taken(drawing.Layers);
        var table = new EntityTable();
        for (var entity = 0; entity < drawing.Entities.Count; entity++)
        {
            if (IsCut(drawing.Entities[entity], taken) && !drawing.IsAreaOnly(drawing.Entities[entity].Type)) AppendParts(table, drawing, entity);
        }

        return table;
    }

    /// <summary>The rows of the outlines of HATCH, SOLID and TRACE on the selected layers, whether these are cut otherwise or not.</summary>
    public static EntityTable BuildAreas(Drawing drawing, LayerSelection selection)
    {
        var taken = selection.Taken(drawing.Layers);
        var table = new EntityTable();
        for (var entity = 0; entity < drawing.Entities.Count; entity++)
        {
            if (IsCut(drawing.Entities[entity], taken) && drawing.Entities[entity].Type is CurveType.Hatch or CurveType.Solid or CurveType.Trace) AppendParts(table, drawing, entity);
        }

        return table;
    }

    /// <summary>The rows of the given entities, in file order, on any layer; an entity that is hidden itself is left out.</summary>
    public static EntityTable Build(Drawing drawing, IEnumerable<int> entities)
    {
        var table = new EntityTable();
        foreach (var entity in entities.Distinct().Order().Where(entity => !drawing.Entities[entity].Hidden)) AppendParts(table, drawing, entity);
        return table;
    }

    private static bool IsCut(in DrawingEntity entity, bool[] taken) => !entity.Hidden && taken[entity.Layer];

    private static void AppendParts(EntityTable table, Drawing drawing, int entityIndex)
    {
        ref var entity = ref drawing.Entities[entityIndex];
        for (var part = entity.FirstPart; part < entity.FirstPart + entity.PartCount; part++)
        {
            ref var drawn = ref drawing.Parts[part];
            if (drawn.IsFreeCurve)
            {
                var curve = drawing.Scale.ToMillimetres(drawing.Curves[drawn.CurveIndex]);
                table.Append(SlotsOf(curve), entityIndex, curve);
                continue;
            }

            if (drawn is { Kind: SegmentKind.Line } && drawn.A == drawn.D && drawn.B == drawn.E) continue; // nothing to cut; the reader has reported it
            var slots = SlotsOf(drawn, drawing.Scale, hasDrawnAngles: entity.Type is CurveType.Arc or CurveType.Circle);
            table.Append(slots, entityIndex, null);
        }
    }

    private static EntitySlots SlotsOf(RationalCurve curve)
    {
        var slots = default(EntitySlots);
        slots[EntitySlot.Kind] = (int)curve.Kind;
        slots.SetStart(curve.Start, curve.StartZ);
        slots.SetEnd(curve.End, curve.EndZ);
        return slots;
    }

    private static EntitySlots SlotsOf(in DrawingPart part, DrawingScale scale, bool hasDrawnAngles)
    {
        var slots = default(EntitySlots);
        slots[EntitySlot.Kind] = (int)part.Kind;
        var first = scale.ToMillimetres(new Point2D(part.A, part.B));
        if (part.Kind == SegmentKind.Line)
        {
            slots.SetStart(first, scale.ToMillimetres(part.C));
            slots.SetEnd(scale.ToMillimetres(new Point2D(part.D, part.E)), scale.ToMillimetres(part.F));
            return slots;
        }

        slots.SetCentre(first, scale.ToMillimetres(part.C));
        slots[EntitySlot.Radius] = scale.ToMillimetres(part.D);
        if (part.Kind == SegmentKind.Arc)
        {
            slots[EntitySlot.StartAngle] = part.E;
            slots[EntitySlot.EndAngle] = WithinOneTurn(part.E + part.F);
        }

        if (part.F < 0.0 || !hasDrawnAngles) slots[EntitySlot.Sweep] = part.F;
        return slots;
    }

    /// <summary>End angle in [0, 360]: 350 to 10 degrees is written as 10, not 370; 270 to 360 remains 360.</summary>
    private static double WithinOneTurn(double degrees) => degrees > 360.0 ? degrees - 360.0 : degrees < -360.0 ? degrees + 360.0 : degrees;
}
