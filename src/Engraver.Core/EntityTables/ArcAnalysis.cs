using Engraver.Core.Geometry;

namespace Engraver.Core.EntityTables;

/// <summary>The paper's "DXF analysis": end points and rotation angle of arcs, start point of circles (paper 001, section 4.2).</summary>
public static class ArcAnalysis
{
    /// <summary>The table with slots 1 to 6 and 15 filled for arcs and circles; circles start at their right quadrant point until sequencing decides. Lines,
    /// ellipses and splines are not changed; a table with these only is returned unchanged.</summary>
    public static EntityTable Analyse(EntityTable table)
    {
        if (!HasArcs(table)) return table;
        var analysed = new EntityTable();
        for (var row = 0; row < table.Count; row++)
        {
            var slots = table.CopySlots(row);
            Complete(ref slots);
            analysed.Append(slots, table.EntityIndexOf(row), table.CurveOf(row));
        }

        return analysed;
    }

    private static bool HasArcs(EntityTable table)
    {
        for (var row = 0; row < table.Count; row++)
        {
            if (table[row].Kind is SegmentKind.Arc or SegmentKind.Circle) return true;
        }

        return false;
    }

    /// <summary>Rotation angle of a counter-clockwise arc, degrees in [0, 360): (end - start) mod 360 (paper 001, eq. 3, read so that it holds across 0
    /// degrees).</summary>
    public static double RotationDegrees(double startDegrees, double endDegrees) => Angle.FromDegrees(endDegrees - startDegrees).Positive().Degrees;

    private static void Complete(ref EntitySlots slots)
    {
        switch ((SegmentKind)(int)slots[EntitySlot.Kind])
        {
            case SegmentKind.Circle:
                if (slots[EntitySlot.Sweep] == 0.0) slots[EntitySlot.Sweep] = 360.0;
                slots.StartCircleAt(Angle.Zero);
                break;
            case SegmentKind.Arc:
                CompleteArc(ref slots);
                break;
            case SegmentKind.Line or SegmentKind.Ellipse or SegmentKind.Spline:
            default:
                break;
        }
    }

    /// <summary>Paper 001, eq. 1 to 3; one formula for all quadrants, degrees handled by <see cref="Angle"/>.</summary>
    private static void CompleteArc(ref EntitySlots slots)
    {
        var (centre, radius, z) = (slots.Centre, slots[EntitySlot.Radius], slots[EntitySlot.CentreZ]);
        slots.SetStart(centre + Vector2D.FromPolar(radius, Angle.FromDegrees(slots[EntitySlot.StartAngle])), z);
        slots.SetEnd(centre + Vector2D.FromPolar(radius, Angle.FromDegrees(slots[EntitySlot.EndAngle])), z);
        if (slots[EntitySlot.Sweep] == 0.0) slots[EntitySlot.Sweep] = RotationDegrees(slots[EntitySlot.StartAngle], slots[EntitySlot.EndAngle]);
    }
}
