using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Objects;

/// <summary>A part of a drawing that is to be replaced.</summary>
/// <param name="Index">Into the drawing's parts.</param>
/// <param name="Part">What takes its place; of an ellipse or spline the part as it was.</param>
/// <param name="Curve">The new ellipse or spline; null for a line, arc or circle.</param>
public sealed record ChangedPart(int Index, DrawingPart Part, RationalCurve? Curve)
{
    /// <summary>In plan, drawing units.</summary>
    public Segment Segment => Curve is null ? Part.InPlan() : Segment.FromCurve(Curve);

    /// <summary>It is within the range of a drawing and did not vanish.</summary>
    public bool IsSound => Segment.Bounds is var box && Fits(box.MinX) && Fits(box.MaxX) && Fits(box.MinY) && Fits(box.MaxY) && (box.Width > 0.0 || box.Height > 0.0) && Segment.Length > 0.0;

    /// <summary>A part that is moved as it is.</summary>
    public static ChangedPart Moved(Drawing drawing, int index, Vector2D way)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        var (part, map) = (drawing.Parts[index], Transform2D.Move(way));
        return part.IsFreeCurve ? new ChangedPart(index, part, drawing.Curves[part.CurveIndex].Mapped(map)) : new ChangedPart(index, part.Transformed(map), null);
    }

    /// <summary>A part of which nothing would be left.</summary>
    public static ChangedPart Vanished(int index) => new(index, DrawingPart.Line(0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), null);

    /// <summary>The drawing with these parts; curves of before stay, because an undone step may refer to them.</summary>
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

    private static bool Fits(double coordinate) => Math.Abs(coordinate) <= Drawing.LargestCoordinate;
}
