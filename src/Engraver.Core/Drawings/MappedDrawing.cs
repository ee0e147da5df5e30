using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>A whole drawing under a similarity of the plane: curves, texts, points and inserts, hidden ones and those on locked layers too. Heights,
/// patterns of linetypes and widths of polylines are scaled, lineweights are not.</summary>
public static class MappedDrawing
{
    /// <returns>False when a coordinate would leave the range of a drawing, or a circle or arc would have no radius; then the drawing is unchanged.</returns>
    public static bool Try(Drawing drawing, Transform2D map, out Drawing mapped)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        mapped = drawing;
        var parts = new GrowingColumn<DrawingPart>();
        for (var i = 0; i < drawing.Parts.Count; i++)
        {
            var part = drawing.Parts[i].IsFreeCurve ? drawing.Parts[i] : drawing.Parts[i].Transformed(map);
            if (!part.InRange) return false;
            parts.Add(part);
        }

        RationalCurve[] curves = [.. drawing.Curves.Select(curve => curve.Mapped(map))];
        if (!Array.TrueForAll(curves, PlacedPart.InRange)) return false;
        PlacedText[] texts = [.. drawing.Texts.Select(text => text.Transformed(map))];
        PlacedPoint[] points = [.. drawing.Points.Select(point => point.Transformed(map))];
        PlacedInsert[] inserts = [.. drawing.Inserts.Select(insert => insert.Moved(map))];
        if (!Array.TrueForAll(texts, text => PlacedPart.InRange(text.Position)) || !Array.TrueForAll(points, point => PlacedPart.InRange(point.Position))) return false;
        mapped = drawing with { Parts = parts, Curves = curves, Texts = texts, Points = points, Inserts = inserts, LinetypeScale = drawing.LinetypeScale * map.Scale, LineStyles = [.. drawing.LineStyles.Select(style => style with { Width = style.Width * map.Scale })] };
        return true;
    }
}
