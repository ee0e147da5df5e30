using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>The side column of ellipses and splines while a drawing is edited: existing curves are kept (an undone step may refer to them), edited ones are
/// added after them.</summary>
internal sealed class EditedCurves(Drawing drawing)
{
    private readonly List<RationalCurve> _added = [];

    /// <summary>False when an edit moved a curve out of the range of a drawing or reduced it to a point.</summary>
    public bool AreInRange => _added.TrueForAll(curve => curve.Bounds is var box && Drawing.Holds(box) && (box.Width > 0.0 || box.Height > 0.0));

    public DrawingPart Transformed(in DrawingPart part, Transform2D map) => part.IsFreeCurve ? Added(part, drawing.Curves[part.CurveIndex].Mapped(map)) : part.Transformed(map);

    public DrawingPart Reversed(in DrawingPart part) => part.IsFreeCurve ? Added(part, drawing.Curves[part.CurveIndex].Reversed()) : part.Reversed();

    public IReadOnlyList<RationalCurve> ToColumn() => _added.Count == 0 ? drawing.Curves : [.. drawing.Curves, .. _added];

    private DrawingPart Added(in DrawingPart part, RationalCurve curve)
    {
        _added.Add(curve);
        return DrawingPart.FreeCurve(part.Entity, part.Kind, drawing.Curves.Count + _added.Count - 1);
    }
}
