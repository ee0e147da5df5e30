using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Nesting;

/// <summary>A contour with what nesting needs: segments in travel order, box, and region when it is closed.</summary>
internal sealed class ContourOutline
{
    /// <summary>Fraction of a segment at which its test point lies: away from ends, middles and quadrant points, where contours often touch.</summary>
    private const double WitnessFraction = 0.3819660112501051;

    /// <summary>Largest distance of the arcs that approximate a curve, as a part of the curve's size.</summary>
    private const double CurveNearness = 1e-4;

    private readonly Segment[] _segments;
    private readonly float _boxSize;
    private readonly double _area;

    private ContourOutline(Segment[] segments, bool closed)
    {
        _segments = segments;
        Region = closed ? new ContourRegion(segments) : null;
        Bounds = Region?.Bounds ?? segments.Aggregate(Bounds2D.Empty, (box, segment) => box.Union(segment.Bounds));
        _boxSize = (float)(Bounds.Width * Bounds.Height);
        _area = Region is null ? 0.0 : Math.Abs(Region.SignedArea);
    }

    public Bounds2D Bounds { get; }

    /// <summary>The enclosed region; null for an open contour.</summary>
    public ContourRegion? Region { get; }

    public static ContourOutline From(Contour contour, ReadOnlySpan<Segment> rows)
    {
        var segments = new Segment[contour.Pieces.Length];
        for (var i = 0; i < segments.Length; i++)
        {
            var piece = contour.Pieces.Span[i];
            segments[i] = piece.Reversed ? rows[piece.Row].Reversed() : rows[piece.Row];
        }

        return new ContourOutline(contour.Closed ? ArcsFor(segments) : segments, contour.Closed);
    }

    /// <summary>Ellipses and splines as arcs, near enough to decide what lies inside what.</summary>
    private static Segment[] ArcsFor(Segment[] segments)
    {
        if (!Array.Exists(segments, segment => segment.IsFreeCurve)) return segments;
        return [.. segments.SelectMany(segment => segment.IsFreeCurve ? BiarcFit.Fit(segment.Curve, Nearness(segment.Bounds)) : [segment])];
    }

    private static double Nearness(Bounds2D box) => Math.Max(CurveNearness * (box.Width + box.Height), double.Epsilon);

    /// <summary>One of <paramref name="count"/> test points spread over the contour.</summary>
    public Point2D Witness(int index, int count)
    {
        var place = (index + WitnessFraction) / count * _segments.Length;
        var segment = Math.Min((int)place, _segments.Length - 1);
        return _segments[segment].PointAt(_segments.Length >= count ? WitnessFraction : place - segment);
    }

    /// <summary>Orders by size of the box, equal boxes (within rounding) by area. An enclosing contour is always larger in this order, so that there are no cycles.</summary>
    public int CompareSize(ContourOutline other) => _boxSize != other._boxSize ? _boxSize.CompareTo(other._boxSize) : _area.CompareTo(other._area);

    /// <summary>True when this contour is closed, larger, and its box contains the other's.</summary>
    public bool CanEnclose(ContourOutline inner, double tolerance) =>
        Region is not null && CompareSize(inner) > 0 && Bounds.Grown(tolerance).Contains(inner.Bounds);
}
