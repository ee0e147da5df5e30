using Engraver.Core.Geometry;
using Engraver.Core.Verification;

namespace Engraver.Core.Operations;

/// <summary>The tabs of a closed stroke: on straight sides and large arcs, those picked by hand first, the others as evenly as these allow.</summary>
internal sealed class TabPlaces
{
    /// <summary>Tabs keep away from the ends of their side, and from each other, by these multiples of their span.</summary>
    private const double FromEnds = 0.75;
    private const double FromOthers = 1.5;

    /// <summary>An arc is large enough from this multiple of the span of a tab.</summary>
    private const double LargeArc = 2.0;

    private readonly List<double> _places = [];
    private readonly List<Point2D> _unplaced = [];
    private readonly List<(double From, double To)> _ranges = [];
    private readonly double _span;

    /// <param name="stroke">Lines and arcs of a closed stroke from its start.</param>
    /// <param name="byHand">Picked places of this stroke.</param>
    /// <param name="span">Length of path of a tab: its width, the diameter of the tool, and its slopes.</param>
    /// <param name="freeAtStart">Length of path from the start that has no tabs.</param>
    /// <param name="freeAtEnd">Length of path to the end that has no tabs.</param>
    public TabPlaces(PartTabs tabs, IReadOnlyList<Segment> stroke, IEnumerable<Point2D> byHand, double span, double freeAtStart, double freeAtEnd)
    {
        _span = span;
        var whole = 0.0;
        foreach (var segment in stroke)
        {
            var isGentle = segment.Kind == SegmentKind.Line || segment.Arc.Radius >= LargeArc * span;
            if (isGentle && segment.Length >= 2.0 * FromEnds * span) _ranges.Add((whole + (FromEnds * span), whole + segment.Length - (FromEnds * span)));
            whole += segment.Length;
        }

        _ranges = [.. _ranges.Select(range => (Math.Max(range.From, freeAtStart + (FromEnds * span)), Math.Min(range.To, whole - freeAtEnd - (FromEnds * span)))).Where(range => range.Item1 <= range.Item2)];
        foreach (var place in byHand)
        {
            if (!Place(AlongOf(stroke, place), tabs.Within)) _unplaced.Add(place);
        }

        var count = tabs.CountOn(whole);
        for (var i = 0; i < count; i++)
        {
            if (!Place(whole * (i + 0.5) / count, double.PositiveInfinity)) Missing++;
        }

        _places.Sort();
        Points = [.. _places.Select(along => PointAt(stroke, along))];
    }

    /// <summary>Distances along the stroke of the middles of the tabs, in order.</summary>
    public IReadOnlyList<double> Middles => _places;

    /// <summary>The middles of the tabs.</summary>
    public IReadOnlyList<Point2D> Points { get; }

    /// <summary>Number of tabs without room, besides those picked by hand.</summary>
    public int Missing { get; }

    /// <summary>Picked places without room for a tab near them.</summary>
    public IReadOnlyList<Point2D> Unplaced => _unplaced;

    /// <summary>Distance along the stroke of its point that is nearest to a place.</summary>
    private static double AlongOf(IReadOnlyList<Segment> stroke, Point2D place)
    {
        var nearest = Enumerable.Range(0, stroke.Count).MinBy(index => stroke[index].DistanceTo(place));
        return stroke.Take(nearest).Sum(segment => segment.Length) + (stroke[nearest].Length * PerpendicularFoot.Place(stroke[nearest], place, double.NaN).Foot);
    }

    private static Point2D PointAt(IReadOnlyList<Segment> stroke, double along)
    {
        var index = 0;
        for (; index < stroke.Count - 1 && along > stroke[index].Length; index++) along -= stroke[index].Length;
        return stroke[index].PointAt(along / stroke[index].Length);
    }

    /// <summary>Adds a tab where there is room, as near as possible to the wanted place.</summary>
    private bool Place(double wanted, double within)
    {
        var free = _places.Aggregate(_ranges, (ranges, other) => [.. ranges.SelectMany(range => Around(range, other))]);
        if (free.Count == 0) return false;
        var place = free.Select(range => Math.Clamp(wanted, range.From, range.To)).MinBy(near => Math.Abs(near - wanted));
        if (Math.Abs(place - wanted) > within) return false;
        _places.Add(place);
        return true;
    }

    /// <summary>What is left of a range beside a tab.</summary>
    private IEnumerable<(double From, double To)> Around((double From, double To) range, double tab)
    {
        var (before, after) = (Math.Min(range.To, tab - (FromOthers * _span)), Math.Max(range.From, tab + (FromOthers * _span)));
        if (before >= range.From) yield return (range.From, before);
        if (after <= range.To) yield return (after, range.To);
    }
}
