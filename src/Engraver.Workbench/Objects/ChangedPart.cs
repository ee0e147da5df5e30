using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Objects;

/// <summary>A replacement of a part of a drawing.</summary>
/// <param name="Index">Index into the drawing's parts.</param>
/// <param name="Part">The new part; for an ellipse or spline the old part.</param>
/// <param name="Curve">The new ellipse or spline; null for a line, arc or circle.</param>
public sealed record ChangedPart(int Index, DrawingPart Part, RationalCurve? Curve)
{
    /// <summary>Its projection to XY, drawing units.</summary>
    public Segment Segment => Curve is null ? Part.InPlan() : Segment.FromCurve(Curve);

    /// <summary>True if it is within the range of a drawing and did not vanish.</summary>
    public bool IsSound => Segment.Bounds is var box && Drawing.Holds(box) && (box.Width > 0.0 || box.Height > 0.0) && Segment.Length > 0.0;

    /// <summary>A moved part.</summary>
    public static ChangedPart Moved(Drawing drawing, int index, Vector2D way)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        var (part, map) = (drawing.Parts[index], Transform2D.Move(way));
        return part.IsFreeCurve ? new ChangedPart(index, part, drawing.Curves[part.CurveIndex].Mapped(map)) : new ChangedPart(index, part.Transformed(map), null);
    }

    /// <summary>A part that would vanish.</summary>
    public static ChangedPart Vanished(int index) => new(index, DrawingPart.Line(0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), null);

    /// <summary>The drawing with these parts; old curves are kept, because undo steps may refer to them.</summary>
    public static Drawing Apply(Drawing drawing, IReadOnlyList<ChangedPart> changes)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(changes);
        var curves = new List<RationalCurve>();
        var parts = new List<(int, DrawingPart)>();
        foreach (var change in changes)
        {
            parts.Add((change.Index, change.Curve is null ? change.Part : DrawingPart.FreeCurve(change.Part.Entity, change.Part.Kind, drawing.Curves.Count + curves.Count)));
            if (change.Curve is { } curve) curves.Add(curve);
        }

        return drawing with { Parts = drawing.Parts.With(parts, []), Curves = curves.Count == 0 ? drawing.Curves : [.. drawing.Curves, .. curves] };
    }
}
