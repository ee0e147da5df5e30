using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>The drawn segments round a tool that moves in short straight cuts, and what of them those cover. One that the tool runs along is covered from foot to foot; only where a run along it begins, turns or ends is it asked exactly.</summary>
/// <param name="drawing">Ellipses and splines as their pieces.</param>
/// <param name="reach">How near a cut covers, millimetres.</param>
/// <param name="cover">Exact: covers what of a drawn segment lies within reach of a cut.</param>
internal sealed class NearSegments(Segment[] drawing, double reach, CoveredParts[] covered, NearSegments.Exactly cover)
{
    /// <summary>In segments shorter than so many times the reach every bit counts.</summary>
    private const double Short = 200.0;

    private readonly List<Follower> _runs = [];
    private Segment _last;
    private bool _hasLast;

    public delegate void Exactly(int drawn, in Segment cut);

    public int Count => _runs.Count;

    /// <summary>Ends what was under way; from now on these are near.</summary>
    public void Set(List<int> near)
    {
        Close();
        _runs.Clear();
        foreach (var drawn in near) _runs.Add(new Follower(drawn, drawing[drawn].Length < Short * reach));
    }

    public void Add(in Segment chord)
    {
        if (!_hasLast || _last.End != chord.Start) Break();
        var length = Math.Sqrt((chord.End - chord.Start).LengthSquared);
        for (var i = 0; i < _runs.Count; i++)
        {
            var run = _runs[i];
            Follow(ref run, chord, length);
            _runs[i] = run;
        }

        (_last, _hasLast) = (chord, true);
    }

    /// <summary>Covers the ends of the runs under way, which may go on.</summary>
    public void Close()
    {
        for (var i = 0; i < _runs.Count; i++)
        {
            var run = _runs[i];
            Close(ref run);
            _runs[i] = run;
        }
    }

    private void Break()
    {
        Close();
        for (var i = 0; i < _runs.Count; i++) _runs[i] = new Follower(_runs[i].Drawn, _runs[i].IsShort);
    }

    private void Follow(ref Follower run, in Segment chord, double length)
    {
        ref readonly var segment = ref drawing[run.Drawn];
        var isFirst = double.IsInfinity(run.Distance);
        var (foot, distance) = FootOf.Place(segment, chord.End, isFirst ? double.NaN : run.Foot);
        var sense = isFirst ? 0 : Math.Sign(foot - run.Foot);
        if (distance - length > reach)
        {
            Close(ref run);
        }
        else if ((sense == run.Sense || run.Sense == 0) && IsAlong(segment, run, foot, distance, chord, length))
        {
            covered[run.Drawn].Add(Math.Min(run.Foot, foot), Math.Max(run.Foot, foot));
            run.IsOpen = true;
        }
        else
        {
            Close(ref run);
            cover(run.Drawn, chord);
        }

        (run.Foot, run.Distance, run.Sense) = (foot, distance, sense == 0 ? run.Sense : sense);
    }

    /// <summary>All between the feet of the two ends of a chord is within reach of it. The distance from a curve is smooth there, and is asked in the middle.</summary>
    private bool IsAlong(in Segment segment, in Follower run, double foot, double distance, in Segment chord, double length)
    {
        var farthest = Math.Max(run.Distance, distance);
        if (!(farthest <= reach) || run.IsShort) return false;
        if (segment.Kind == SegmentKind.Line) return true;
        if (segment.IsFreeCurve) return chord.Line.DistanceTo(segment.PointAt((run.Foot + foot) / 2.0)) <= reach;
        return farthest + (length * length / (8.0 * segment.Arc.Radius)) <= reach && Math.Abs(foot - run.Foot) < 0.5; // round a circle the foot jumps
    }

    private void Close(ref Follower run)
    {
        if (run.IsOpen) cover(run.Drawn, _last);
        run.IsOpen = false;
    }

    /// <summary>A segment that the tool may be running along.</summary>
    private struct Follower(int drawn, bool isShort)
    {
        public readonly int Drawn = drawn;

        /// <summary>Every bit of it counts.</summary>
        public readonly bool IsShort = isShort;

        /// <summary>Parameter of the place nearest to the end of the last chord.</summary>
        public double Foot;

        /// <summary>And how far that is; nothing is known before the first chord.</summary>
        public double Distance = double.PositiveInfinity;

        /// <summary>Whether the foot moved on (1) or back (-1).</summary>
        public int Sense;

        /// <summary>True while the last chord is covered from foot to foot only.</summary>
        public bool IsOpen;
    }
}
