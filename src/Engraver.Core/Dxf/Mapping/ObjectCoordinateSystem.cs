using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>Transforms from the system in which an entity is written (OCS, given by its extrusion direction) to the world.</summary>
internal static class ObjectCoordinateSystem
{
    /// <summary>Transforms every part of the shape to the world; notes a tilted entity, and refuses one with a coordinate that is too large.</summary>
    public static void TransformToWorld(EntityRecord record, CurveShape shape)
    {
        var direction = record.Extrusion();
        if (direction == default)
        {
            shape.Warnings.Add(record.Finding(DxfRules.NoExtrusion, "", refused: false));
            return;
        }

        var system = Placement.FromExtrusion(direction);
        if (system.IsIdentity) return;
        var worst = PlacementOutcome.Exact;
        var before = shape.Curves.ToList();
        shape.Curves.Clear();
        foreach (ref var part in shape.MutableParts)
        {
            worst = (PlacementOutcome)Math.Max((int)worst, (int)PlacedPart.Try(part, before, system, shape.Curves, out part));
        }

        if (worst == PlacementOutcome.OutOfRange) record.Refuse(DxfRules.OutOfRange, record.Line, "");
        else if (worst == PlacementOutcome.Tilted) shape.Warnings.Add(record.Finding(DxfRules.TiltedCurve, "", refused: false));
    }
}
