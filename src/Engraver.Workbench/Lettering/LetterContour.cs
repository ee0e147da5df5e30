using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Fonts;

namespace Engraver.Workbench.Lettering;

/// <summary>A contour of a glyph under an affine map: lines, arcs where the map keeps them circular, ellipses and splines otherwise; exact.</summary>
/// <param name="parts">Ellipses and splines refer to <paramref name="curves"/>.</param>
internal sealed class LetterContour(List<DrawingPart> parts, List<RationalCurve> curves)
{
    private readonly List<RationalCurve> _own = [];

    public LetterContour()
        : this([], [])
    {
    }

    public IReadOnlyList<DrawingPart> Parts => parts;

    /// <summary>The curves of the parts, and of no others.</summary>
    public IReadOnlyList<RationalCurve> Curves => curves;

    /// <summary>False if a coordinate is not a usable number; the parts are then not complete.</summary>
    public bool IsInRange { get; private set; } = true;

    /// <summary>True if the map is not level: the plan view is cut.</summary>
    public bool IsTilted { get; private set; }

    /// <summary>Smallest box in plan.</summary>
    public Bounds2D Bounds => parts.Aggregate(Bounds2D.Empty, (box, part) => box.Union(SegmentOf(part).Bounds));

    public static LetterContour Of(GlyphContour contour, in Placement map)
    {
        var placed = new LetterContour();
        var from = contour.Start;
        foreach (var piece in contour.Pieces)
        {
            placed.Add(from, piece, map);
            from = piece.End;
        }

        return placed;
    }

    public static LetterContour Of(LayoutRule rule, in Placement map)
    {
        var placed = new LetterContour();
        placed.Place(DrawingPart.Line(0, rule.From.X, rule.From.Y, 0.0, rule.To.X, rule.To.Y, 0.0), map);
        return placed;
    }

    /// <summary>Lines, arcs and circles at a height.</summary>
    public static LetterContour Of(IReadOnlyList<Segment> segments, double z) => new(
        [.. segments.Select(segment => segment.Kind == SegmentKind.Line ? DrawingPart.Line(0, segment.Start.X, segment.Start.Y, z, segment.End.X, segment.End.Y, z) : DrawingPart.Arc(0, segment.Arc, z))],
        []);

    /// <summary>A part in plan.</summary>
    public Segment SegmentOf(in DrawingPart part) => part.IsFreeCurve ? Segment.FromCurve(curves[part.CurveIndex]) : part.InPlan();

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
        var outcome = PlacedPart.Try(part, _own, map, curves, out var placed);
        IsTilted |= outcome == PlacementOutcome.Tilted;
        IsInRange &= outcome != PlacementOutcome.OutOfRange;
        if (outcome != PlacementOutcome.OutOfRange) parts.Add(placed);
    }
}
