using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>What of a drawn segment lies beside places of other segments that were cut. To the judge drawn lines so close together are one.</summary>
/// <remarks>A gap is asked in its middle: what the cut segment found there covers is done with, the rest is asked again. So few steps tell a gap among thousands of lines on one another.</remarks>
internal sealed class NeighbourCover
{
    private readonly Segment[] _parts;
    private readonly int[] _owners;
    private readonly double _reach;
    private readonly SegmentIndex _index;
    private readonly BoxTree.Measure _measure;
    private readonly Predicate<int> _isOther;
    private readonly Stack<(double From, double To)> _open = [];
    private int _drawn;

    /// <param name="drawing">Ellipses and splines as their pieces.</param>
    /// <param name="covered">What of each was cut.</param>
    /// <param name="reach">How close together two drawn places are one, millimetres.</param>
    public NeighbourCover(Segment[] drawing, CoveredParts[] covered, double reach)
    {
        var (parts, owners) = (new List<Segment>(drawing.Length), new List<int>(drawing.Length));
        for (var i = 0; i < drawing.Length; i++)
        {
            foreach (var (from, to) in covered[i].Parts())
            {
                parts.Add(SegmentPart.Of(drawing[i], from, to));
                owners.Add(i);
            }
        }

        (_parts, _owners, _reach, _index) = ([.. parts], [.. owners], reach, new SegmentIndex([.. parts]));
        _isOther = part => _owners[part] != _drawn;
        _measure = (part, place) => _isOther(part) ? _parts[part].DistanceTo(place) : double.PositiveInfinity;
    }

    public long Steps => _index.Steps;

    /// <summary>Covers what of a gap lies beside others that were cut.</summary>
    /// <param name="drawn">Number of the segment.</param>
    /// <param name="gap">Of the segment, as fractions.</param>
    /// <param name="shortest">Shorter parts of the gap are left as they are; a fraction.</param>
    /// <param name="found">Takes what is covered.</param>
    public void Cover(int drawn, in Segment segment, (double From, double To) gap, double shortest, CoveredParts found)
    {
        _drawn = drawn;
        _open.Push(gap);
        while (_open.TryPop(out var part))
        {
            if (part.To - part.From < shortest || !_index.ComesNear(SegmentPart.Of(segment, part.From, part.To), _reach, _isOther)) continue;
            var middle = (part.From + part.To) / 2.0;
            var (from, to) = CoveredAt(segment, middle);
            if (from < to) found.Add(from, to);
            _open.Push((part.From, from));
            _open.Push((to, part.To));
        }
    }

    /// <summary>What is covered round a place; nothing of it when no other comes near there.</summary>
    private (double From, double To) CoveredAt(in Segment segment, double fraction)
    {
        var part = _index.NearestBy(_measure, segment.PointAt(fraction), _reach, _reach / 2.0, out var distance);
        if (part < 0) return (fraction, fraction);
        var round = (_reach - distance) / Math.Max(segment.Length, double.Epsilon); // all so near to the place is near the part
        var covered = new CoveredParts(0.0);
        covered.Add(fraction - round, fraction + round);
        CutNearSegment.CoverAny(segment, _parts[part], _reach, covered);
        foreach (var (from, to) in covered.Parts())
        {
            if (from <= fraction && to >= fraction) return (from, to);
        }

        return (fraction, fraction);
    }
}
