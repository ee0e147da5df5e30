using System.Diagnostics;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf;

/// <summary>What a placement makes of a line, an arc or a circle, and whether that still is one.</summary>
internal static class PlacedPart
{
    /// <summary>Slope under which a tilted circle passes for a flat one: its plan is then an ellipse whose axes differ by less than 1e-12 of the radius.</summary>
    private const double FlatSlope = 1e-6;

    /// <summary>Relative difference of two scales under which an arc stays an arc; rounding in deeply nested inserts stays far below.</summary>
    private const double EqualScale = 1e-9;

    public static PlacementOutcome Try(in DrawingPart part, in Placement placement, out DrawingPart placed) => part.Kind == SegmentKind.Line
        ? TryLine(part, placement, out placed)
        : TryArc(part, placement, out placed);

    /// <summary>The finding that belongs to an outcome other than <see cref="PlacementOutcome.Exact"/>.</summary>
    public static DiagnosticRule RuleFor(PlacementOutcome outcome) => outcome switch
    {
        PlacementOutcome.Tilted => DxfRules.TiltedCurve,
        PlacementOutcome.UnequallyScaled => DxfRules.UnequalScale,
        PlacementOutcome.OutOfRange => DxfRules.OutOfRange,
        _ => throw new UnreachableException(),
    };

    private static PlacementOutcome TryLine(in DrawingPart part, in Placement placement, out DrawingPart placed)
    {
        var start = placement.Apply(new Vector3D(part.A, part.B, part.C));
        var end = placement.Apply(new Vector3D(part.D, part.E, part.F));
        placed = DrawingPart.Line(part.Entity, start.X, start.Y, start.Z, end.X, end.Y, end.Z);
        return InRange(start) && InRange(end) ? PlacementOutcome.Exact : PlacementOutcome.OutOfRange;
    }

    /// <summary>An arc stays an arc when x and y axis stay level, square and equally long; a mirror turns its sense round.</summary>
    private static PlacementOutcome TryArc(in DrawingPart part, in Placement placement, out DrawingPart placed)
    {
        placed = part;
        var x = placement.XAxis;
        var y = placement.YAxis;
        var scale = x.Length;
        if (Math.Abs(x.Z) > FlatSlope * scale || Math.Abs(y.Z) > FlatSlope * y.Length) return PlacementOutcome.Tilted;
        if (Math.Abs(scale - y.Length) > EqualScale * scale || Math.Abs(x.Dot(y)) > EqualScale * scale * scale) return PlacementOutcome.UnequallyScaled;
        var centre = placement.Apply(new Vector3D(part.A, part.B, part.C));
        var radius = part.D * scale;
        if (!InRange(centre) || !(radius <= DxfNumber.Largest)) return PlacementOutcome.OutOfRange;
        placed.A = centre.X;
        placed.B = centre.Y;
        placed.C = centre.Z;
        placed.D = radius;
        var turn = Angle.Direction(x.X, x.Y).Degrees;
        var mirrored = (x.X * y.Y) - (x.Y * y.X) < 0.0;
        placed.E = Angle.FromDegrees(mirrored ? turn - part.E : turn + part.E).Positive().Degrees;
        placed.F = mirrored ? -part.F : part.F;
        return PlacementOutcome.Exact;
    }

    private static bool InRange(Vector3D point) =>
        Math.Abs(point.X) <= DxfNumber.Largest && Math.Abs(point.Y) <= DxfNumber.Largest && Math.Abs(point.Z) <= DxfNumber.Largest;
}
