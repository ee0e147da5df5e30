using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Fonts;

namespace Engraver.Workbench.Lettering;

/// <summary>The curves of a layout in the drawing: lines, arcs where the map keeps them circular, ellipses and splines otherwise; exact.</summary>
public sealed class LetterCurves
{
    private readonly List<DrawingPart> _parts = [];
    private readonly List<RationalCurve> _curves = [];
    private readonly List<RationalCurve> _own = [];

    /// <summary>Ellipses and splines refer to <see cref="Curves"/>.</summary>
    public IReadOnlyList<DrawingPart> Parts => _parts;

    public IReadOnlyList<RationalCurve> Curves => _curves;

    /// <summary>False if a coordinate is not a usable number; the parts are then not complete.</summary>
    public bool IsInRange { get; private set; } = true;

    /// <summary>True if the plane of the letters is not level: their plan view is cut.</summary>
    public bool IsTilted { get; private set; }

    public static LetterCurves Of(TextLayout layout)
    {
        ArgumentNullException.ThrowIfNull(layout);
        var curves = new LetterCurves();
        foreach (var glyph in layout.Glyphs)
        {
            var map = layout.Plane.After(glyph.Map);
            foreach (var contour in glyph.Curves.Contours) curves.Add(contour, map);
        }

        foreach (var rule in layout.Rules) curves.Place(DrawingPart.Line(0, rule.From.X, rule.From.Y, 0.0, rule.To.X, rule.To.Y, 0.0), layout.Plane);
        return curves;
    }

    /// <summary>The box of a glyph in the plane of its layout.</summary>
    internal static Bounds2D BoundsOf(GlyphPlace glyph)
    {
        var curves = new LetterCurves();
        foreach (var contour in glyph.Curves.Contours) curves.Add(contour, glyph.Map);
        return curves._parts.Aggregate(Bounds2D.Empty, (box, part) => box.Union(part.IsFreeCurve ? curves._curves[part.CurveIndex].Bounds : part.InPlan().Bounds));
    }

    private void Add(GlyphContour contour, in Placement map)
    {
        var from = contour.Start;
        foreach (var piece in contour.Pieces)
        {
            Add(from, piece, map);
            from = piece.End;
        }
    }

    private void Add(FontPoint from, GlyphPiece piece, in Placement map)
    {
        var (start, end) = (new Point2D(from.X, from.Y), new Point2D(piece.End.X, piece.End.Y));
        switch (piece.Kind)
        {
            case GlyphPieceKind.Line:
                if (start != end) Place(DrawingPart.Line(0, start.X, start.Y, 0.0, end.X, end.Y, 0.0), map);
                break;
            case GlyphPieceKind.Arc:
                if (start != end) Place(DrawingPart.Arc(0, ArcSegment.FromBulge(start, end, piece.Bulge), 0.0), map);
                break;
            case GlyphPieceKind.Quadratic:
                Place(map, from, piece.Control1, piece.End);
                break;
            default:
                Place(map, from, piece.Control1, piece.Control2, piece.End);
                break;
        }
    }

    private void Place(in Placement map, params ReadOnlySpan<FontPoint> controls)
    {
        var points = new double[controls.Length * BezierSpan.Stride];
        for (var i = 0; i < controls.Length; i++) (points[i * BezierSpan.Stride], points[(i * BezierSpan.Stride) + 1], points[(i * BezierSpan.Stride) + 3]) = (controls[i].X, controls[i].Y, 1.0);
        var span = new BezierSpan(points);
        if (span.IsPoint) return;
        _own.Clear();
        _own.Add(new RationalCurve(SegmentKind.Spline, [span]));
        Place(DrawingPart.FreeCurve(0, SegmentKind.Spline, 0), map);
    }

    private void Place(in DrawingPart part, in Placement map)
    {
        var outcome = PlacedPart.Try(part, _own, map, _curves, out var placed);
        IsTilted |= outcome == PlacementOutcome.Tilted;
        IsInRange &= outcome != PlacementOutcome.OutOfRange;
        if (outcome != PlacementOutcome.OutOfRange) _parts.Add(placed);
    }
}
