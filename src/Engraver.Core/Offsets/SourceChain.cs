using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>A contour prepared for its offset: only lines and arcs, none without length, every piece starting exactly where the previous one ends.</summary>
internal sealed class SourceChain
{
    /// <summary>Part of the tolerance of an ellipse's or spline's arcs by which a corner between two of them may be cut: a joint that is meant to be smooth
    /// stays smooth.</summary>
    private const double CurveJointShare = 0.01;

    private SourceChain(PathPiece[] pieces, OffsetSource[] sources, bool closed, double smoothness) => (Pieces, Sources, Closed, Smoothness) = (pieces, sources, closed, smoothness);

    public PathPiece[] Pieces { get; }

    /// <summary>The source segment of each piece.</summary>
    public OffsetSource[] Sources { get; }

    public bool Closed { get; }

    /// <summary>Millimetres by which the offset may differ from the exact offset where two pieces are almost tangent.</summary>
    public double Smoothness { get; }

    /// <summary>For a closed curve without width, which is a line there and back: the side of its inside, 1 left, -1 right; 0 for all other contours.</summary>
    public int FlatTurn { get; private init; }

    /// <param name="contour">The contour as drawn.</param>
    /// <param name="number">Number of the contour among all contours that are offset.</param>
    /// <param name="options">Tolerances.</param>
    /// <param name="tolerance">Length that counts as zero, millimetres.</param>
    /// <returns>Null when no segment has a length.</returns>
    public static SourceChain? From(OffsetContour contour, int number, OffsetOptions options, double tolerance)
    {
        if (contour is { Closed: true, Segments: [{ IsFreeCurve: true } only] } && FlatCurve.From(only.Curve, options.MaxErrorMm) is { } flat) return Flat(flat.Places, flat.Turn, number, tolerance);
        var hasCurves = false;
        var pieces = new List<PathPiece>(contour.Segments.Count);
        var sources = new List<OffsetSource>(contour.Segments.Count);
        for (var i = 0; i < contour.Segments.Count; i++)
        {
            var segment = contour.Segments[i];
            hasCurves |= segment.IsFreeCurve;
            if (!segment.IsFreeCurve) AddWithLength(pieces, PathPiece.FromSegment(segment), tolerance);
            else foreach (var part in BiarcFit.Fit(segment.Curve, options.MaxErrorMm)) AddWithLength(pieces, PathPiece.FromSegment(part), tolerance);
            while (sources.Count < pieces.Count) sources.Add(new OffsetSource(number, i, IsJoin: false));
        }

        if (pieces.Count == 0) return null;
        var smoothness = hasCurves ? Math.Max(tolerance, CurveJointShare * options.MaxErrorMm) : tolerance;
        var joined = Joined(pieces, sources, contour.Closed, tolerance);
        return new SourceChain(joined, [.. sources], contour.Closed, smoothness);
    }

    /// <summary>The same points in the opposite direction.</summary>
    public SourceChain Reversed()
    {
        var pieces = new PathPiece[Pieces.Length];
        for (var i = 0; i < pieces.Length; i++) pieces[i] = Pieces[^(i + 1)].Reversed();
        return new SourceChain(pieces, [.. Sources.Reverse()], Closed, Smoothness);
    }

    public SourceChain Moved(Vector2D by) => by == default ? this : new([.. Pieces.Select(piece => piece.Moved(by))], Sources, Closed, Smoothness) { FlatTurn = FlatTurn };

    private static SourceChain? Flat(IReadOnlyList<Point2D> places, int turn, int number, double tolerance)
    {
        var pieces = new List<PathPiece>();
        for (var i = 1; i < places.Count; i++) AddWithLength(pieces, PathPiece.Line(places[i - 1], places[i]), tolerance);
        return pieces.Count == 0 ? null : new SourceChain([.. pieces], [.. pieces.Select(_ => new OffsetSource(number, 0, IsJoin: false))], true, tolerance) { FlatTurn = turn };
    }

    private static void AddWithLength(List<PathPiece> pieces, in PathPiece piece, double tolerance)
    {
        if (piece.Length > tolerance && (piece.IsArc || piece.Start != piece.End)) pieces.Add(piece);
    }

    /// <summary>Closes the gaps: both ends move to the middle. An arc keeps its sweep and is adapted to its new ends.</summary>
    private static PathPiece[] Joined(List<PathPiece> pieces, List<OffsetSource> sources, bool closed, double tolerance)
    {
        var count = pieces.Count;
        var starts = new Point2D[count + 1];
        (starts[0], starts[count]) = (pieces[0].Start, pieces[^1].End);
        for (var i = 1; i < count; i++) starts[i] = Meeting(pieces[i - 1].End, pieces[i].Start);
        if (closed) starts[0] = starts[count] = Meeting(pieces[^1].End, pieces[0].Start);
        var joined = new List<PathPiece>(count);
        var kept = new List<OffsetSource>(count);
        for (var i = 0; i < count; i++)
        {
            var piece = Between(pieces[i], starts[i], starts[i + 1], tolerance);
            if (piece.Length > tolerance)
            {
                joined.Add(piece);
                kept.Add(sources[i]);
            }
            else if (i + 1 < count) starts[i + 1] = starts[i];
            else if (joined.Count > 0) joined[^1] = Between(joined[^1], joined[^1].Start, starts[count], tolerance);
        }

        if (joined.Count == 0) (joined, kept) = ([pieces[0]], [sources[0]]);
        sources.Clear();
        sources.AddRange(kept);
        return [.. joined];
    }

    private static Point2D Meeting(Point2D end, Point2D start) => end == start ? end : end + ((start - end) * 0.5);

    private static PathPiece Between(in PathPiece piece, Point2D start, Point2D end, double tolerance)
    {
        if (piece.Start == start && piece.End == end) return piece;
        if (!piece.IsArc) return PathPiece.Line(start, end);
        var moved = Math.Max(piece.Start.DistanceTo(start), piece.End.DistanceTo(end));
        if (moved <= tolerance || piece.IsWholeTurn || start.DistanceTo(end) <= tolerance) return PathPiece.Arc(piece.Centre, piece.Radius, piece.From, piece.Sweep, start, end);
        return PathPiece.FromSegment(Segment.FromArc(ArcSegment.FromBulge(start, end, Math.Tan(piece.Sweep / 4.0)), start, end));
    }
}
