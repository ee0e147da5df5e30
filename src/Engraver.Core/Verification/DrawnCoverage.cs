using Engraver.Core.Geometry;
using Engraver.Core.Verification.Corners;

namespace Engraver.Core.Verification;

/// <summary>The parts of a drawing that were cut, as parameter intervals of each segment: exact for segments of any length.</summary>
/// <remarks>A cut is compared only with the segments nearest to it, so that thousands of segments that meet in a point or coincide take no more time than the
/// same number elsewhere. The remaining parts are finally compared with the cut parts next to them (<see cref="NeighbourCover"/>).</remarks>
internal sealed class DrawnCoverage
{
    /// <summary>Fraction of the length already found missing: higher accuracy is not needed.</summary>
    private const double MissingKnown = 1e-5;

    private readonly Segment[] _drawing;
    private readonly SegmentIndex _index;
    private readonly TraceTolerances _tolerances;
    private readonly double _reach;
    private readonly CoveredParts[] _covered;
    private readonly FollowedSegment _followed;
    private readonly CornerCover _corners;
    private readonly int[] _cuts;
    private int _cut;
    private long _steps;

    /// <param name="drawing">Ellipses and splines as their pieces.</param>
    /// <param name="index">Index of the drawing.</param>
    /// <param name="corners">Corners that may be rounded.</param>
    public DrawnCoverage(Segment[] drawing, SegmentIndex index, DrawnCorners corners, TraceTolerances tolerances)
    {
        (_drawing, _index, _tolerances, _reach, _cuts) = (drawing, index, tolerances, tolerances.Coverage, new int[drawing.Length]);
        _covered = new CoveredParts[drawing.Length];
        for (var i = 0; i < _covered.Length; i++) _covered[i] = new CoveredParts();
        _followed = new FollowedSegment(drawing, _reach, _covered, Cover);
        _corners = new CornerCover(drawing, corners, _reach, _covered);
    }

    /// <summary>Number of chords, and of pairs of a segment and a cut, that were compared.</summary>
    public long Steps => _steps + _corners.Steps;

    /// <summary>Adds a straight cut between two samples, or a dot.</summary>
    /// <param name="nearest">The segment nearest to its end, or a segment near enough; -1 for none.</param>
    public void AddChord(Point2D from, Point2D to, int nearest)
    {
        _steps++;
        var chord = Segment.FromLine(from, to);
        _followed.Add(chord);
        if (nearest == _followed.Drawn) return;
        _followed.Set(nearest);
        _followed.Add(chord);
    }

    /// <summary>The segment that the last chord followed; -1 for none.</summary>
    public int Followed => _followed.Drawn;

    /// <summary>The next chord continues from a place near this one.</summary>
    public void Follow(int nearest) => _followed.Set(nearest);

    /// <summary>From now on <see cref="Add"/> reports a new cut.</summary>
    public void Begin()
    {
        _cut++;
        _corners.Begin();
    }

    /// <summary>Adds a straight cut between two samples where it rounds a corner.</summary>
    /// <param name="nearest">The segment nearest to its end.</param>
    public void RoundChord(Point2D from, Point2D to, int nearest) => _corners.AddChord(from, to, nearest);

    /// <summary>Adds a cut along a line or an arc where it rounds a corner; repeated calls for one cut evaluate a corner once.</summary>
    /// <param name="nearest">The segment nearest to some part of it.</param>
    public void Round(int nearest, in Segment path) => _corners.Add(nearest, path);

    /// <summary>Adds a cut along a line, or an arc of at most half a turn, of any length.</summary>
    /// <param name="drawn">A segment near some part of the cut; repeated calls for one cut evaluate it once.</param>
    public void Add(int drawn, in Segment path)
    {
        if (_cuts[drawn] == _cut) return;
        _cuts[drawn] = _cut;
        Cover(drawn, path);
    }

    /// <summary>Length of the drawing that no cut came near, and a place in the first missing part. Gaps shorter than a step of the drawing are ignored: chords
    /// between samples cut corners.</summary>
    /// <param name="farthest">The largest distance of a cut from the drawing: it can be this far from the segment with which it was compared, and nearer to a
    /// neighbouring segment.</param>
    public (double Length, Point2D? At) Missing(double farthest)
    {
        var together = _reach + Math.Min(_reach, farthest + (_reach / 100.0));
        _followed.Close();
        var (missing, first) = (0.0, (Point2D?)null);
        NeighbourCover? neighbours = null;
        for (var i = 0; i < _covered.Length; i++)
        {
            if (!Gaps(i, _covered[i]).Any()) continue;
            neighbours ??= new NeighbourCover(_drawing, _index, _covered, together);
            foreach (var (from, to) in Gaps(i, WithNeighbours(i, neighbours, missing)))
            {
                var length = LengthOf(_drawing[i], from, to);
                missing += length;
                first ??= _drawing[i].PointAt(from + ((to - from) * Math.Min(0.5, LongestIgnored(_drawing[i].Length) / (2.0 * length))));
            }
        }

        return (missing, first);
    }

    private CoveredParts WithNeighbours(int drawn, NeighbourCover neighbours, double missing)
    {
        var length = _drawing[drawn].Length;
        var shortest = Math.Max(LongestIgnored(length) / 2.0, MissingKnown * missing) / length;
        var covered = new CoveredParts();
        foreach (var (from, to) in _covered[drawn].Parts()) covered.Add(from, to);
        foreach (var gap in Gaps(drawn, _covered[drawn])) neighbours.Cover(drawn, gap, shortest, covered);
        return covered;
    }

    /// <summary>The gaps that are not ignored.</summary>
    private IEnumerable<(double From, double To)> Gaps(int drawn, CoveredParts covered)
    {
        var longest = LongestIgnored(_drawing[drawn].Length);
        return covered.Gaps().Where(gap => LengthOf(_drawing[drawn], gap.From, gap.To) is > 0.0 and var length && length >= longest * 0.999);
    }

    private double LongestIgnored(double length) => length / _tolerances.StepsFor(length);

    private static double LengthOf(in Segment segment, double from, double to)
    {
        if (from <= 0.0 && to >= 1.0) return segment.Length;
        if (!segment.IsFreeCurve) return segment.Length * (to - from);
        const int Chords = 32;
        var sum = 0.0;
        for (var i = 0; i < Chords; i++) sum += segment.PointAt(from + ((to - from) * i / Chords)).DistanceTo(segment.PointAt(from + ((to - from) * (i + 1) / Chords)));
        return sum;
    }

    private void Cover(int drawn, in Segment cut)
    {
        _steps++;
        SegmentCutCover.CoverAny(_drawing[drawn], cut, _reach, _covered[drawn]);
    }
}
