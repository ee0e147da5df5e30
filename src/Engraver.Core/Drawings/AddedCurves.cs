using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>Curves that are added after those of a drawing, whose indices remain.</summary>
public sealed class AddedCurves(Drawing drawing)
{
    private readonly List<DrawingEntity> _entities = [];
    private readonly List<DrawingPart> _parts = [];
    private readonly List<RationalCurve> _curves = [];
    private readonly List<LineStyle> _styles = [.. drawing.LineStyles];

    /// <summary>Number of the line style that states only a lineweight.</summary>
    public int StyleOf(int lineweight)
    {
        var style = LineStyle.ByLayer with { Lineweight = lineweight };
        var number = _styles.IndexOf(style);
        if (number >= 0) return number;
        _styles.Add(style);
        return _styles.Count - 1;
    }

    /// <summary>Adds an entity and returns its index in the drawing of <see cref="ToDrawing"/>.</summary>
    /// <param name="entity">The position of its parts is filled in here.</param>
    /// <param name="parts">Ellipses and splines refer to <paramref name="curves"/>.</param>
    public int Add(DrawingEntity entity, IReadOnlyList<DrawingPart> parts, IReadOnlyList<RationalCurve> curves)
    {
        ArgumentNullException.ThrowIfNull(parts);
        ArgumentNullException.ThrowIfNull(curves);
        var index = drawing.Entities.Count + _entities.Count;
        entity.FirstPart = drawing.Parts.Count + _parts.Count;
        entity.PartCount = parts.Count;
        foreach (var part in parts) _parts.Add(part.IsFreeCurve ? DrawingPart.FreeCurve(index, part.Kind, drawing.Curves.Count + _curves.Count + part.CurveIndex) : part with { Entity = index });
        _entities.Add(entity);
        _curves.AddRange(curves);
        return index;
    }

    public Drawing ToDrawing() => _entities.Count == 0
        ? drawing
        : drawing with { Entities = drawing.Entities.With([], _entities), Parts = drawing.Parts.With([], _parts), LineStyles = _styles.Count == drawing.LineStyles.Count ? drawing.LineStyles : _styles, Curves = _curves.Count == 0 ? drawing.Curves : [.. drawing.Curves, .. _curves] };
}
