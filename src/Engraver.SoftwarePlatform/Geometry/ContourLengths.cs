using Avalonia;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Geometry;

/// <summary>Distances along the figures of a geometry, one figure after the other.</summary>
internal sealed class ContourLengths(List<Polyline> figures)
{
    public double Total { get; } = figures.Sum(LengthOf);

    public bool TryFind(double distance, out Point point, out Point tangent)
    {
        (point, tangent) = (default, default);
        var at = 0.0;
        foreach (var (start, end, _) in Pieces())
        {
            var length = (end - start).Length;
            if (length > 0 && distance <= at + length)
            {
                var direction = (end - start) / length;
                var place = start + direction * Math.Max(0, distance - at);
                (point, tangent) = (new Point(place.X, place.Y), new Point(direction.X, direction.Y));
                return true;
            }
            at += length;
        }
        return false;
    }

    /// <summary>The part between two distances, one figure for each figure that it touches.</summary>
    public VectorPath Piece(double from, double to)
    {
        var piece = new VectorPath();
        var at = 0.0;
        foreach (var (start, end, isFirst) in Pieces())
        {
            var length = (end - start).Length;
            double first = Math.Max(from, at), last = Math.Min(to, at + length);
            if (last > first)
            {
                var direction = (end - start) / length;
                if (piece.IsEmpty || isFirst)
                    piece.MoveTo(Place(start + direction * (first - at)));
                piece.LineTo(Place(start + direction * (last - at)));
            }
            at += length;
        }
        return piece;
    }

    private IEnumerable<(Vector Start, Vector End, bool IsFirst)> Pieces()
    {
        foreach (var figure in figures)
        {
            for (var i = 0; i < figure.SegmentCount; i++)
            {
                var (start, end) = figure.Segment(i);
                yield return (start, end, i == 0);
            }
        }
    }

    private static double LengthOf(Polyline figure) => Enumerable.Range(0, figure.SegmentCount).Sum(i => Length(figure.Segment(i)));

    private static double Length((Vector Start, Vector End) segment) => (segment.End - segment.Start).Length;

    private static Point Place(Vector vector) => new(vector.X, vector.Y);
}
