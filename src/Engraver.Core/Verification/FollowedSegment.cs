using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>The drawn segment along which a tool moves in short straight cuts, and the part of it that they cover: from foot to foot; exact evaluation is used
/// only where a run along it starts, turns or ends.</summary>
/// <param name="drawing">Ellipses and splines as their pieces.</param>
/// <param name="reach">Distance within which a cut covers, millimetres.</param>
/// <param name="cover">Exact evaluation: covers the part of a drawn segment within reach of a cut.</param>
internal sealed class FollowedSegment(Segment[] drawing, double reach, CoveredParts[] covered, FollowedSegment.Exactly cover)
{
    /// <summary>In segments shorter than this multiple of the reach, every part counts.</summary>
    private const double Short = 200.0;

    private Segment _last;
    private bool _isShort;
    private double _foot;
    private double _distance = double.PositiveInfinity;
    private int _sense;
    private bool _isOpen;

    public delegate void Exactly(int drawn, in Segment cut);

    /// <summary>Number of the segment; -1 for none.</summary>
    public int Drawn { get; private set; } = -1;

    /// <summary>Ends the current run; from now on this segment is followed.</summary>
    public void Set(int drawn)
    {
        Break();
        (Drawn, _isShort) = (drawn, drawn >= 0 && drawing[drawn].Length < Short * reach);
    }

    public void Add(in Segment chord)
    {
        if (Drawn < 0) return;
        if (_last.End != chord.Start) Break();
        Follow(chord, Math.Sqrt((chord.End - chord.Start).LengthSquared));
        _last = chord;
    }

    /// <summary>Covers the end of the current run, which can continue.</summary>
    public void Close()
    {
        if (_isOpen) cover(Drawn, _last);
        _isOpen = false;
    }

    private void Break()
    {
        Close();
        (_distance, _sense) = (double.PositiveInfinity, 0);
    }

    private void Follow(in Segment chord, double length)
    {
        ref readonly var segment = ref drawing[Drawn];
        var isFirst = double.IsInfinity(_distance);
        var (foot, distance) = PerpendicularFoot.Place(segment, chord.End, isFirst ? double.NaN : _foot);
        var sense = isFirst ? 0 : Math.Sign(foot - _foot);
        if (distance - length > reach)
        {
            Close();
        }
        else if ((sense == _sense || _sense == 0) && IsAlong(segment, foot, distance, chord, length))
        {
            covered[Drawn].Add(Math.Min(_foot, foot), Math.Max(_foot, foot));
            _isOpen = true;
        }
        else
        {
            Close();
            cover(Drawn, chord);
        }

        (_foot, _distance, _sense) = (foot, distance, sense == 0 ? _sense : sense);
    }

    /// <summary>True when the whole part between the feet of the two ends of a chord is within reach of it. The distance from a curve is smooth there and is
    /// evaluated in the middle.</summary>
    private bool IsAlong(in Segment segment, double foot, double distance, in Segment chord, double length)
    {
        var farthest = Math.Max(_distance, distance);
        if (!(farthest <= reach) || _isShort) return false;
        if (segment.Kind == SegmentKind.Line) return true;
        if (segment.IsFreeCurve) return chord.Line.DistanceTo(segment.PointAt((_foot + foot) / 2.0)) <= reach;
        return farthest + (length * length / (8.0 * segment.Arc.Radius)) <= reach && Math.Abs(foot - _foot) < 0.5; // on a circle the foot jumps
    }
}
