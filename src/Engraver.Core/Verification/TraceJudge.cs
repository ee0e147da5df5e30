using Engraver.Core.Geometry;
using Engraver.Core.Verification.Corners;

namespace Engraver.Core.Verification;

/// <summary>Judges a run while it is in progress: takes the drawing once, then samples and spans in order of time. Memory depends on the drawing, time on the
/// number of samples and spans.</summary>
/// <remarks>Meaning and numbers are those of <see cref="TraceComparison.Compare"/>. Not thread safe.</remarks>
public sealed class TraceJudge : ITraceJudge
{
    /// <summary>Maximum number of places checked between two samples; a machine moves a few hundredths of a millimetre from one sample to the next.</summary>
    private const int MaxStepsOfChord = 64;

    private readonly SegmentIndex _index;
    private readonly DrawnCorners _corners;
    private readonly SpanDeviation _spans;
    private readonly DrawnCoverage _coverage;
    private readonly double _reach;
    private readonly double _allowed;
    private long _samples;
    private double _largest;
    private double _largestAtCorner;
    private double _extra;
    private TraceSample? _worst;
    private TraceSample? _last;
    private bool _wasOff;

    /// <param name="drawing">The drawing to cut, millimetres; order and direction are irrelevant. Ellipses and splines are exact, not the arcs that were cut
    /// for them.</param>
    /// <param name="tolerances">Tolerances that define what counts as cut and which gaps are ignored.</param>
    public TraceJudge(IReadOnlyList<Segment> drawing, TraceTolerances tolerances)
    {
        ArgumentNullException.ThrowIfNull(tolerances);
        Segment[] pieces = [.. CurvePieces.Split(drawing)];
        (_reach, _allowed) = (tolerances.Coverage, tolerances.Deviation);
        _index = new SegmentIndex(pieces);
        _corners = DrawnCorners.Of(pieces, tolerances);
        _coverage = new DrawnCoverage(pieces, _index, _corners, tolerances);
        _spans = new SpanDeviation(pieces, _index, _corners, _coverage, tolerances);
    }

    /// <summary>Number of segments and boxes checked so far.</summary>
    internal long Steps => _index.Steps + _corners.Steps + _coverage.Steps;

    /// <summary>Adds a machine position; between two consecutive cutting samples the machine moved straight.</summary>
    public void Add(in TraceSample sample)
    {
        if (sample.Cutting)
        {
            _samples++;
            Judge(sample);
        }

        _last = sample;
    }

    /// <summary>Adds a span that the machine moved along.</summary>
    public void Add(in TraceSpan span)
    {
        if (span.Cutting)
        {
            _samples += span.Samples;
            Judge(span.At(0.0));
            var found = _spans.Measure(span, _largest, _largestAtCorner, _extra);
            if (found.Largest > _largest) (_largest, _worst) = (found.Largest, span.At(found.At));
            _largestAtCorner = found.LargestAtCorner;
            _extra += found.Extra;
            _coverage.Follow(_index.NearEnoughTo(span.Path.End, _reach, out var atEnd));
            _wasOff = atEnd > _reach && !(_corners.NearestTo(span.Path.End, atEnd, _reach, out var fromCorner) >= 0 && fromCorner <= _reach);
        }

        _last = span.At(1.0);
    }

    public void BeginRun() => _last = null;

    /// <summary>The result so far; after the last sample, the final result.</summary>
    public TraceVerdict Verdict()
    {
        var (missing, at) = _coverage.Missing(_largest);
        return new TraceVerdict(_samples, _largest, _worst, missing, at, _extra) { CornerDeviation = _corners.IsUsed ? _largestAtCorner : null };
    }

    private void Judge(in TraceSample sample)
    {
        var nearest = _index.NearEnoughTo(sample.Place, Math.Min(_largest, _reach), out var distance);
        var deviation = distance;
        if (distance > Math.Min(_largest, _reach) && _corners.NearestTo(sample.Place, distance, Math.Min(_largest, _reach), out var fromCorner) >= 0)
        {
            deviation = fromCorner;
            if (fromCorner <= _allowed) _largestAtCorner = Math.Max(_largestAtCorner, distance);
        }

        if (_worst is null || deviation > _largest) (_largest, _worst) = (deviation, sample);
        var isOff = deviation > _reach;
        if (_last is { Cutting: true } before)
        {
            if (isOff || _wasOff) _extra += before.Place.DistanceTo(sample.Place);
            if (before.Place != sample.Place)
            {
                AddChord(before.Place, sample.Place, nearest);
                _coverage.RoundChord(before.Place, sample.Place, nearest);
            }
        }
        else
        {
            _coverage.AddChord(sample.Place, sample.Place, nearest); // a lone sample is a dot
        }

        _wasOff = isOff;
    }

    /// <summary>Where a chord runs from one segment to another, there can be shorter segments between them.</summary>
    private void AddChord(Point2D from, Point2D to, int nearest)
    {
        if (nearest != _coverage.Followed)
        {
            var (chord, steps) = (Segment.FromLine(from, to), Math.Min(MaxStepsOfChord, (int)Math.Ceiling(from.DistanceTo(to) / _reach)));
            _coverage.Begin();
            for (var i = 1; i < steps; i++)
            {
                var between = _index.NearEnoughTo(chord.PointAt((double)i / steps), Math.Min(_largest, _reach), out var distance);
                if (distance <= _reach) _coverage.Add(between, chord);
            }
        }

        _coverage.AddChord(from, to, nearest);
    }
}
