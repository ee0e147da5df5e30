using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>What of a drawn segment lies beside places of other segments that were cut. To the judge drawn lines so close together are one.</summary>
/// <remarks>A gap is asked in its middle: what the cut segment found there covers is done with, the rest is asked again. So few steps tell a gap among thousands of lines on one another.</remarks>
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
    /// <param name="index">Of the drawing.</param>
    /// <param name="covered">What of each was cut.</param>
    /// <param name="reach">How close together two drawn places are one, millimetres.</param>
    public NeighbourCover(Segment[] drawing, SegmentIndex index, CoveredParts[] covered, double reach)
    {
        (_drawing, _index, _reach) = (drawing, index, reach);
        _cut = [.. covered.Select(parts => parts.Parts())];
        _measure = (other, place) => CutNear(other, place).Distance;
    }

    /// <summary>Covers what of a gap lies beside others that were cut.</summary>
    /// <param name="drawn">Number of the segment.</param>
    /// <param name="gap">Of the segment, as fractions.</param>
    /// <param name="shortest">Shorter parts of the gap are left as they are; a fraction.</param>
    /// <param name="found">Takes what is covered.</param>
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

    /// <summary>What is covered round a place; nothing of it when no other comes near there.</summary>
    private (double From, double To) CoveredAt(double fraction)
    {
        ref readonly var segment = ref _drawing[_drawn];
        var place = segment.PointAt(fraction);
        var other = _index.NearestBy(_measure, place, _reach, _reach / 2.0, out var distance);
        if (other < 0) return (fraction, fraction);
        var (first, last) = _cut[other][CutNear(other, place).Part];
        var round = (_reach - distance) / Math.Max(segment.Length, double.Epsilon); // all so near to the place is near the part
        var covered = new CoveredParts();
        covered.Add(fraction - round, fraction + round);
        CutNearSegment.CoverAny(segment, SegmentPart.Of(_drawing[other], first, last), _reach, covered);
        foreach (var (from, to) in covered.Parts())
        {
            if (from <= fraction && to >= fraction) return (from, to);
        }

        return (fraction, fraction);
    }

    /// <summary>The nearest part of another segment that was cut: where the foot is, or before or behind it; round a circle also the first and the last.</summary>
    private (double Distance, int Part) CutNear(int other, Point2D place)
    {
        var parts = _cut[other];
        if (other == _drawn || parts.Count == 0) return (double.PositiveInfinity, -1);
        ref readonly var segment = ref _drawing[other];
        if (segment.Kind is SegmentKind.Arc or SegmentKind.Circle && Math.Abs(segment.Arc.Centre.DistanceTo(place) - segment.Arc.Radius) > _reach) return (double.PositiveInfinity, -1); // of crowded rings nearly all
        var (foot, distance) = FootOf.Place(segment, place, double.NaN);
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
            if (SegmentsApart.MayComeNear(path, SegmentPart.Of(_drawing[other], Math.Max(from, parts[part].From), Math.Min(to, parts[part].To)), _reach)) return true;
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
