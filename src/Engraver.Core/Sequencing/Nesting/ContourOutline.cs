using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Nesting;

/// <summary>A contour with the data for nesting: its box and, on demand, its segments in travel order and, when it is closed, its region.</summary>
internal sealed class ContourOutline
{
    /// <summary>Fraction of a segment of its test point: away from ends, middles and quadrant points, where contours often touch.</summary>
    private const double WitnessFraction = 0.3819660112501051;

    /// <summary>Largest distance of the arcs that approximate a curve, as a fraction of the curve's size.</summary>
    private const double CurveNearness = 1e-4;

    private readonly Contour _contour;
    private readonly ReadOnlyMemory<Segment> _rows;
    private readonly float _boxSize;

    /// <summary>Segments in travel order; created when the box does not answer a query, which is necessary for few contours.</summary>
    private Segment[]? _segments;
    private ContourRegion? _region;

    public ContourOutline(Contour contour, ReadOnlyMemory<Segment> rows)
    {
        (_contour, _rows) = (contour, rows);
        Bounds = contour.Closed && HasFreeCurves() ? Region.Bounds : BoundsOfPieces();
        _boxSize = (float)(Bounds.Width * Bounds.Height);
    }

    public Bounds2D Bounds { get; }

    /// <summary>True for a closed contour: it has a <see cref="Region"/>.</summary>
    public bool IsClosed => _contour.Closed;

    /// <summary>The enclosed region of a closed contour.</summary>
    public ContourRegion Region => _region ??= new ContourRegion(Segments);

    private Segment[] Segments => _segments ??= InTravelOrder();

    private double Area => IsClosed ? Math.Abs(Region.SignedArea) : 0.0;

    private Segment[] InTravelOrder()
    {
        var segments = new Segment[_contour.Pieces.Length];
        for (var i = 0; i < segments.Length; i++) segments[i] = SegmentOf(_contour.Pieces.Span[i]);
        return IsClosed ? ArcsFor(segments) : segments;
    }

    private Segment SegmentOf(ContourPiece piece) => piece.Reversed ? _rows.Span[piece.Row].Reversed() : _rows.Span[piece.Row];

    private bool HasFreeCurves()
    {
        var rows = _rows.Span;
        foreach (var piece in _contour.Pieces.Span)
        {
            if (rows[piece.Row].IsFreeCurve) return true;
        }

        return false;
    }

    private Bounds2D BoundsOfPieces()
    {
        var box = Bounds2D.Empty;
        var rows = _rows.Span;
        foreach (var piece in _contour.Pieces.Span)
        {
            ref readonly var row = ref rows[piece.Row];
            if (row.Kind == SegmentKind.Line) box = box.Including(row.Start).Including(row.End);
            else box = box.Union(SegmentOf(piece).Bounds);
        }

        return box;
    }

    /// <summary>Ellipses and splines as arcs, near enough to decide which contour is inside which.</summary>
    private static Segment[] ArcsFor(Segment[] segments)
    {
        if (!Array.Exists(segments, segment => segment.IsFreeCurve)) return segments;
        return [.. segments.SelectMany(segment => segment.IsFreeCurve ? BiarcFit.Fit(segment.Curve, Nearness(segment.Bounds)) : [segment])];
    }

    private static double Nearness(Bounds2D box) => Math.Max(CurveNearness * (box.Width + box.Height), double.Epsilon);

    /// <summary>One of <paramref name="count"/> test points spread over the contour.</summary>
    public Point2D Witness(int index, int count)
    {
        var segments = Segments;
        var place = (index + WitnessFraction) / count * segments.Length;
        var segment = Math.Min((int)place, segments.Length - 1);
        return segments[segment].PointAt(segments.Length >= count ? WitnessFraction : place - segment);
    }

    /// <summary>Orders by size of the box, equal boxes (within rounding) by area. An enclosing contour is always larger in this order, which excludes
    /// cycles.</summary>
    public int CompareSize(ContourOutline other) => _boxSize != other._boxSize ? _boxSize.CompareTo(other._boxSize) : Area.CompareTo(other.Area);

    /// <summary>True when this contour is closed, larger, and its box contains the other's.</summary>
    public bool CanEnclose(ContourOutline inner, double tolerance) =>
        IsClosed && CompareSize(inner) > 0 && Bounds.Grown(tolerance).Contains(inner.Bounds);
}
