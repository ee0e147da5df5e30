namespace Engraver.Fonts.Strokes;

/// <summary>A drawn or composed shape.</summary>
/// <param name="Left">The left bearing, which is added to x of its strokes and anchors; 0 for a mark.</param>
/// <param name="Advance">0 for a mark.</param>
/// <param name="Mark">The name of the anchor on which a mark is placed; null for a glyph.</param>
/// <param name="Anchors">Points of the shape by name.</param>
internal sealed record StrokeShape(double Left, double Advance, string? Mark, IReadOnlyList<Stroke> Strokes, IReadOnlyDictionary<string, FontPoint> Anchors)
{
    public GlyphCurves ToCurves() => new(Advance, [.. Strokes.Select(stroke => stroke.Placed(Left, 0, 1).ToContour())]);
}
