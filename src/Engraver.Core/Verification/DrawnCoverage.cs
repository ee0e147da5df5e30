using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Which parts of a drawing a cut has passed near enough, as parameter intervals of each segment: exact, however long the segments are.</summary>
internal sealed class DrawnCoverage
{
    private const int FewCandidates = 8;

    /// <summary>Of the reach: a shorter cut may be a step of many that follow a segment across it.</summary>
    private const double LongPath = 100.0;

    private readonly Segment[] _drawing;
    private readonly SegmentIndex _index;
    private readonly TraceTolerances _tolerances;
    private readonly double _reach;
    private readonly CoveredParts[] _covered;
    private readonly NearSegments _near;
    private readonly List<int> _candidates = [];
    private Bounds2D _nearBox = Bounds2D.Empty;
    private double _margin = 1.0;

    /// <param name="drawing">Ellipses and splines as their pieces.</param>
    public DrawnCoverage(Segment[] drawing, SegmentIndex index, TraceTolerances tolerances)
    {
        (_drawing, _index, _tolerances, _reach) = (drawing, index, tolerances, tolerances.Coverage);
        _covered = new CoveredParts[drawing.Length];
        for (var i = 0; i < _covered.Length; i++) _covered[i] = new CoveredParts(LongestIgnored(drawing[i].Length) / 2.0 / Math.Max(drawing[i].Length, double.Epsilon));
        _near = new NearSegments(drawing, _reach, _covered, Cover);
    }

    /// <summary>Sine of the angle from which on a line that crosses a segment covers less of it than is kept (see <see cref="CoveredParts"/>): every line of a hatch crosses thousands.</summary>
    public static double Crossed(in Segment segment, TraceTolerances tolerances)
    {
        var length = segment.Length;
        return length > 0.0 ? Math.Min(1.0, 4.0 * tolerances.Coverage * tolerances.StepsFor(length) / length) : 1.0;
    }

    /// <summary>A straight cut between two samples, or a dot. Quick when cuts follow one another: what lies around is looked up once for many.</summary>
    public void AddChord(Point2D from, Point2D to)
    {
        var box = Bounds2D.FromCorners(from, to).Grown(_reach);
        if (!_nearBox.Contains(box)) LookAround(box);
        if (_near.Count > 0) _near.Add(Segment.FromLine(from, to));
    }

    /// <summary>A cut along a line, or an arc of at most half a turn, of any length.</summary>
    public void Add(in Segment path)
    {
        if (path.Kind == SegmentKind.Line && path.Length > LongPath * _reach) _index.AlongNotAcross(path.Line, _reach, _candidates);
        else _index.Along(path, _reach, _candidates);
        foreach (var candidate in _candidates) Cover(candidate, path);
    }

    /// <summary>Length of the drawing that no cut came near, and where the first of it is. Gaps shorter than a step of the drawing are none: chords between samples cut corners.</summary>
    public (double Length, Point2D? At) Missing()
    {
        _near.Close();
        var missing = 0.0;
        Point2D? first = null;
        for (var i = 0; i < _covered.Length; i++)
        {
            var segment = _drawing[i];
            var longest = LongestIgnored(segment.Length);
            foreach (var (from, to) in _covered[i].Gaps())
            {
                var length = LengthOf(segment, from, to);
                if (length == 0.0 || length < longest * 0.999) continue;
                missing += length;
                first ??= segment.PointAt(from + ((to - from) * Math.Min(0.5, longest / (2.0 * length))));
            }
        }

        return (missing, first);
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

    private void LookAround(Bounds2D box)
    {
        if (_near.Count > FewCandidates) _margin /= 2.0;
        else if (_near.Count < 2) _margin *= 2.0;
        _margin = Math.Clamp(_margin, 2.0 * _reach, 100.0);
        _nearBox = box.Grown(_margin);
        var middle = new Point2D((_nearBox.MinX + _nearBox.MaxX) / 2.0, (_nearBox.MinY + _nearBox.MaxY) / 2.0);
        var radius = Math.Sqrt((_nearBox.Width * _nearBox.Width) + (_nearBox.Height * _nearBox.Height)) / 2.0;
        _index.Around(middle, radius, _candidates);
        _candidates.RemoveAll(candidate => _drawing[candidate].DistanceTo(middle) > radius);
        _near.Set(_candidates);
    }

    private void Cover(int drawn, in Segment cut)
    {
        ref readonly var segment = ref _drawing[drawn];
        var covered = _covered[drawn];
        if (segment.IsFreeCurve) CutNearCurve.Cover(segment, cut, _reach, covered);
        else if (segment.Kind == SegmentKind.Line && cut.Kind == SegmentKind.Line) CutNearSegment.CoverLine(segment.Line, cut.Line, _reach, covered);
        else CutNearSegment.Cover(segment, cut, _reach, covered);
    }
}

/// <summary>Parameter intervals of one segment that have been covered. Memory is bounded: bits shorter than what may be missing anyway are forgotten unless the next bit touches them.</summary>
internal sealed class CoveredParts(double shortestKept)
{
    private const double Touching = 1e-9;
    private const int ManyParts = 64;
    private List<(double From, double To)>? _parts;
    private double _from = double.NaN;
    private double _to = double.NaN;

    public void Add(double from, double to)
    {
        (from, to) = (Math.Max(0.0, from), Math.Min(1.0, to));
        if (!(from <= to)) return;
        if (from <= _to + Touching && to >= _from - Touching)
        {
            (_from, _to) = (Math.Min(_from, from), Math.Max(_to, to));
            return;
        }

        Keep();
        (_from, _to) = (from, to);
    }

    /// <summary>What is not covered, in order.</summary>
    public IEnumerable<(double From, double To)> Gaps()
    {
        var parts = new List<(double From, double To)>(_parts ?? []);
        if (!double.IsNaN(_from)) parts.Add((_from, _to));
        parts.Sort();
        var end = 0.0;
        foreach (var (from, to) in parts)
        {
            if (from > end + Touching) yield return (end, from);
            end = Math.Max(end, to);
        }

        if (end < 1.0 - Touching) yield return (end, 1.0);
    }

    private void Keep()
    {
        if (double.IsNaN(_from) || _to - _from < shortestKept) return;
        _parts ??= [];
        _parts.Add((_from, _to));
        if (_parts.Count >= ManyParts && (_parts.Count & (_parts.Count - 1)) == 0) Merge(_parts);
    }

    private static void Merge(List<(double From, double To)> parts)
    {
        parts.Sort();
        var kept = 0;
        for (var i = 1; i < parts.Count; i++)
        {
            if (parts[i].From <= parts[kept].To + Touching) parts[kept] = (parts[kept].From, Math.Max(parts[kept].To, parts[i].To));
            else parts[++kept] = parts[i];
        }

        parts.RemoveRange(kept + 1, parts.Count - kept - 1);
    }
}
