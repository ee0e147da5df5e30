using Engraver.Core.Geometry;

namespace Engraver.Core.Reshaping;

/// <summary>An object as its parts in plan, joined end to start, in its direction.</summary>
/// <param name="Parts">Parts, at least one.</param>
/// <param name="Closed">True when it ends at its start.</param>
public sealed record EntityPath(IReadOnlyList<Segment> Parts, bool Closed)
{
    /// <summary>Two crossings nearer to each other than this fraction of the object's size are a single crossing at a joint.</summary>
    private const double SamePlace = 1e-9;

    private readonly double _near = SamePlace * Parts.Aggregate(Bounds2D.Empty, (box, part) => box.Union(part.Bounds)) switch { var box => box.Width + box.Height };

    public PathPlace Start => new(0, 0.0, Parts[0].Start);

    public PathPlace End => new(Parts.Count - 1, 1.0, Parts[^1].End);

    /// <summary>The place of the object that is nearest to a point.</summary>
    public PathPlace Nearest(Point2D point) => Parts.Select((part, index) => PathPlace.Nearest(index, part, point)).MinBy(place => place.At.DistanceTo(point));

    /// <summary>Crossings of edges with the object, in its direction, each once. The ends of an open object are not crossings.</summary>
    /// <param name="edges">The cutting edges.</param>
    /// <param name="lengthened">True when lines and arcs among the edges also cut beyond their ends.</param>
    public IReadOnlyList<PathPlace> Crossings(IEnumerable<Segment> edges, bool lengthened = false)
    {
        var found = new List<PathPlace>();
        foreach (var edge in edges)
        {
            for (var index = 0; index < Parts.Count; index++)
            {
                var part = Parts[index];
                if (!lengthened && !Touch(part.Bounds, edge.Bounds)) continue;
                foreach (var place in lengthened ? SegmentCrossings.Carriers(part, edge).Where(at => SegmentCrossings.IsOn(part, at)) : SegmentCrossings.Find(part, edge)) found.Add(PlaceOf(index, place));
            }
        }

        return Distinct(found);
    }

    /// <summary>The pieces from one place to another along the object; over the seam of a closed one when the second place is not after the first.</summary>
    public IReadOnlyList<PathRange> Between(PathPlace from, PathPlace to)
    {
        if (!Closed || to.Position > from.Position) return Straight(from, to);
        var (behind, ahead) = (Straight(from, End), Straight(Start, to));
        var isOneOverSeam = Parts.Count == 1 && behind.Count + ahead.Count == 2;
        return isOneOverSeam ? [new PathRange(0, from.Fraction, 1.0 + to.Fraction, from.At, to.At)] : [.. behind, .. ahead];
    }

    private PathPlace PlaceOf(int index, Point2D at) => new(index, Math.Clamp(PathPlace.FractionOf(Parts[index], at), 0.0, 1.0), at);

    private bool Touch(Bounds2D a, Bounds2D b) => a.MinX <= b.MaxX + _near && b.MinX <= a.MaxX + _near && a.MinY <= b.MaxY + _near && b.MinY <= a.MaxY + _near;

    private List<PathPlace> Distinct(List<PathPlace> found)
    {
        var kept = new List<PathPlace>();
        foreach (var place in found.OrderBy(place => place.Position))
        {
            if (!Closed && (IsAt(place, Start) || IsAt(place, End))) continue;
            if (kept.Count == 0 || !IsAt(kept[^1], place)) kept.Add(place);
        }

        if (Closed && kept.Count > 1 && Parts.Count - kept[^1].Position + kept[0].Position < 0.5 && kept[^1].At.IsNear(kept[0].At, _near)) kept.RemoveAt(kept.Count - 1);
        return kept;
    }

    private bool IsAt(PathPlace a, PathPlace b) => Math.Abs(a.Position - b.Position) < 0.5 && a.At.IsNear(b.At, _near);

    private List<PathRange> Straight(PathPlace from, PathPlace to)
    {
        var pieces = new List<PathRange>();
        for (var index = from.Part; index <= to.Part; index++)
        {
            var part = Parts[index];
            var begin = index == from.Part ? from : new PathPlace(index, 0.0, part.Start);
            var end = index == to.Part ? to : new PathPlace(index, 1.0, part.End);
            if (end.Fraction > begin.Fraction && !(end.At.IsNear(begin.At, _near) && end.Fraction - begin.Fraction < 0.5)) pieces.Add(new PathRange(index, begin.Fraction, end.Fraction, begin.At, end.At));
        }

        return pieces;
    }
}
