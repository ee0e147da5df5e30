using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>The part of a drawn segment next to cut places of other segments. The judge treats drawn lines this close together as one.</summary>
/// <remarks>A gap is evaluated in its middle: the part covered by the cut segment found there is complete, the rest is evaluated again. A gap among thousands
/// of coincident lines therefore needs few steps.</remarks>
internal sealed class NeighbourCover
{
    private readonly Segment[] _drawing;
    private readonly IReadOnlyList<(double From, double To)>[] _cut;
    private readonly double _reach;
    private readonly SegmentIndex _index;
    private readonly BoxTree.Measure _measure;
    private readonly Stack<(double From, double To)> _open = [];
    private int _drawn;

    /// <param name="drawing">Ellipses and splines as their pieces.</param>
    /// <param name="index">Index of the drawing.</param>
    /// <param name="covered">The cut parts of each segment.</param>
    /// <param name="reach">Distance within which two drawn places count as one, millimetres.</param>
    public NeighbourCover(Segment[] drawing, SegmentIndex index, CoveredParts[] covered, double reach)
    {
        (_drawing, _index, _reach) = (drawing, index, reach);
        _cut = [.. covered.Select(parts => parts.Parts())];
        _measure = (other, place) => CutNear(other, place).Distance;
    }

    /// <summary>Covers the parts of a gap next to other segments that were cut.</summary>
    /// <param name="drawn">Number of the segment.</param>
    /// <param name="gap">Gap of the segment, as fractions.</param>
    /// <param name="shortest">Shorter parts of the gap stay unchanged; a fraction.</param>
    /// <param name="found">Receives the covered parts.</param>
    public void Cover(int drawn, (double From, double To) gap, double shortest, CoveredParts found)
    {
        _drawn = drawn;
        _open.Push(gap);
        while (_open.TryPop(out var part))
        {
            if (part.To - part.From < shortest) continue;
            var (from, to) = CoveredAt((part.From + part.To) / 2.0);
            if (from < to) found.Add(from, to);
            else if (!ComesNear(SegmentPart.Of(_drawing[drawn], part.From, part.To))) continue;
            _open.Push((part.From, from));
            _open.Push((to, part.To));
        }
    }

    /// <summary>The covered part around a place; empty when no other segment is near it.</summary>
    private (double From, double To) CoveredAt(double fraction)
    {
        ref readonly var segment = ref _drawing[_drawn];
        var place = segment.PointAt(fraction);
        var other = _index.NearestBy(_measure, place, _reach, _reach / 2.0, out var distance);
        if (other < 0) return (fraction, fraction);
        var (first, last) = _cut[other][CutNear(other, place).Part];
        var round = (_reach - distance) / Math.Max(segment.Length, double.Epsilon); // all points this near to the place are near the part
        var covered = new CoveredParts();
        covered.Add(fraction - round, fraction + round);
        SegmentCutCover.CoverAny(segment, SegmentPart.Of(_drawing[other], first, last), _reach, covered);
        foreach (var (from, to) in covered.Parts())
        {
            if (from <= fraction && to >= fraction) return (from, to);
        }

        return (fraction, fraction);
    }

    /// <summary>The nearest part of another segment that was cut: at the foot, or before or after it; for a circle also the first and the last.</summary>
    private (double Distance, int Part) CutNear(int other, Point2D place)
    {
        var parts = _cut[other];
        if (other == _drawn || parts.Count == 0) return (double.PositiveInfinity, -1);
        ref readonly var segment = ref _drawing[other];
        if (segment.Kind is SegmentKind.Arc or SegmentKind.Circle && Math.Abs(segment.Arc.Centre.DistanceTo(place) - segment.Arc.Radius) > _reach) return (double.PositiveInfinity, -1); // excludes nearly all crowded rings
        var (foot, distance) = PerpendicularFoot.Place(segment, place, double.NaN);
        var after = FirstEndingAt(parts, foot);
        if (after < parts.Count && parts[after].From <= foot) return (distance, after);
        var nearest = (Distance: double.PositiveInfinity, Part: -1);
        foreach (var part in (ReadOnlySpan<int>)[after - 1, after, 0, parts.Count - 1])
        {
            if (part < 0 || part >= parts.Count) continue;
            var toPart = Math.Min(segment.PointAt(parts[part].From).DistanceTo(place), segment.PointAt(parts[part].To).DistanceTo(place));
            if (toPart < nearest.Distance) nearest = (toPart, part);
        }

        return nearest;
    }

    private bool ComesNear(Segment path) => _index.ComesNear(path, _reach, (other, from, to) =>
    {
        if (other == _drawn) return false;
        var parts = _cut[other];
        for (var part = FirstEndingAt(parts, from); part < parts.Count && parts[part].From <= to; part++)
        {
            if (SegmentSeparation.CanBeNear(path, SegmentPart.Of(_drawing[other], Math.Max(from, parts[part].From), Math.Min(to, parts[part].To)), _reach)) return true;
        }

        return false;
    });

    /// <summary>The first part that does not end before a place.</summary>
    private static int FirstEndingAt(IReadOnlyList<(double From, double To)> parts, double fraction)
    {
        var (low, high) = (0, parts.Count);
        while (low < high)
        {
            var middle = (low + high) / 2;
            if (parts[middle].To < fraction) low = middle + 1;
            else high = middle;
        }

        return low;
    }
}
