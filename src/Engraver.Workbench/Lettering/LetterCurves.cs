using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Lettering;

/// <summary>The curves of a layout in the drawing. Outlines of an outline font that overlap are united; everything else is exact.</summary>
public sealed class LetterCurves
{
    private readonly List<DrawingPart> _parts = [];
    private readonly List<RationalCurve> _curves = [];

    /// <summary>Ellipses and splines refer to <see cref="Curves"/>.</summary>
    public IReadOnlyList<DrawingPart> Parts => _parts;

    public IReadOnlyList<RationalCurve> Curves => _curves;

    /// <summary>False if a coordinate is not a usable number; the parts are then not complete.</summary>
    public bool IsInRange { get; private set; } = true;

    /// <summary>True if the plane of the letters is not level: their plan view is cut.</summary>
    public bool IsTilted { get; private set; }

    /// <summary>False if outlines that overlap could not be united: they are as the font has them.</summary>
    public bool IsUnited { get; private set; } = true;

    /// <param name="maxError">Largest distance of the arcs of united outlines from the curves of the font, drawing units. Outlines that do not overlap remain
    /// curves.</param>
    public static LetterCurves Of(TextLayout layout, double maxError)
    {
        ArgumentNullException.ThrowIfNull(layout);
        var curves = new LetterCurves();
        var outlines = new OutlineUnion(layout.Plane, maxError);
        foreach (var glyph in layout.Glyphs)
        {
            var map = layout.Plane.After(glyph.Map);
            List<LetterContour> contours = [.. glyph.Curves.Contours.Select(contour => LetterContour.Of(contour, map))];
            if (glyph.Font.Font.IsOutline && outlines.IsLevel && contours.TrueForAll(contour => contour.IsInRange)) outlines.Add(glyph.Curves, contours);
            else contours.ForEach(curves.Add);
        }

        foreach (var contour in outlines.Unite()) curves.Add(contour);
        foreach (var rule in layout.Rules) curves.Add(LetterContour.Of(rule, layout.Plane));
        curves.IsUnited = outlines.IsComplete;
        return curves;
    }

    /// <summary>The box of a glyph in the plane of its layout.</summary>
    internal static Bounds2D BoundsOf(GlyphPlace glyph) => glyph.Curves.Contours.Aggregate(Bounds2D.Empty, (box, contour) => box.Union(LetterContour.Of(contour, glyph.Map).Bounds));

    private void Add(LetterContour contour)
    {
        foreach (var part in contour.Parts) _parts.Add(part.IsFreeCurve ? DrawingPart.FreeCurve(part.Entity, part.Kind, part.CurveIndex + _curves.Count) : part);
        _curves.AddRange(contour.Curves);
        IsTilted |= contour.IsTilted;
        IsInRange &= contour.IsInRange;
    }
}
