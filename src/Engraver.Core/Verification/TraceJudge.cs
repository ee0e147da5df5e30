using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>The judge of a run that listens while it goes on: takes the drawing once, then samples and spans in order of time. Memory follows the drawing, time the number of samples and spans told.</summary>
/// <remarks>Meaning and numbers are those of <see cref="TraceComparison.Compare"/>. Not thread safe.</remarks>
public sealed class TraceJudge : ITraceJudge
{
    /// <summary>Places that are looked at between two samples; a machine goes a few hundredths of a millimetre from one to the next.</summary>
    private const int MostStepsOfChord = 64;

    private readonly SegmentIndex _index;
    private readonly SpanDeviation _spans;
    private readonly DrawnCoverage _coverage;
    private readonly double _reach;
    private long _samples;
    private double _largest;
    private double _extra;
    private TraceSample? _worst;
    private TraceSample? _last;
    private bool _wasOff;

    /// <param name="drawing">What was to be cut, millimetres; order and direction do not matter. Ellipses and splines are exact here, not the arcs that were cut for them.</param>
    /// <param name="tolerances">What counts as cut, and how short a gap is none.</param>
    public TraceJudge(IReadOnlyList<Segment> drawing, TraceTolerances tolerances)
    {
        ArgumentNullException.ThrowIfNull(tolerances);
        Segment[] pieces = [.. CurvePieces.Split(drawing)];
        _reach = tolerances.Coverage;
        _index = new SegmentIndex(pieces);
        _coverage = new DrawnCoverage(pieces, _index, tolerances);
        _spans = new SpanDeviation(pieces, _index, _coverage, tolerances);
    }

    /// <summary>Segments and boxes that were looked at so far.</summary>
    internal long Steps => _index.Steps + _coverage.Steps;

    /// <summary>The machine was here; between two consecutive cutting samples it went straight.</summary>
    public void Add(in TraceSample sample)
    {
        if (sample.Cutting)
        {
            _samples++;
            Judge(sample);
        }

        _last = sample;
    }

    /// <summary>The machine went along here.</summary>
    public void Add(in TraceSpan span)
    {
        if (span.Cutting)
        {
            _samples += span.Samples;
            Judge(span.At(0.0));
            var found = _spans.Measure(span, _largest, _extra);
            if (found.Largest > _largest) (_largest, _worst) = (found.Largest, span.At(found.At));
            _extra += found.Extra;
            _coverage.Follow(_index.NearEnoughTo(span.Path.End, _reach, out var atEnd));
            _wasOff = atEnd > _reach;
        }

        _last = span.At(1.0);
    }

    /// <summary>What is known so far; with no more to come, the verdict.</summary>
    public TraceVerdict Verdict()
    {
        var (missing, at) = _coverage.Missing(_largest);
        return new TraceVerdict(_samples, _largest, _worst, missing, at, _extra);
    }

    private void Judge(in TraceSample sample)
    {
        var nearest = _index.NearEnoughTo(sample.Place, Math.Min(_largest, _reach), out var deviation);
        if (_worst is null || deviation > _largest) (_largest, _worst) = (deviation, sample);
        var isOff = deviation > _reach;
        if (_last is { Cutting: true } before)
        {
            if (isOff || _wasOff) _extra += before.Place.DistanceTo(sample.Place);
            if (before.Place != sample.Place) AddChord(before.Place, sample.Place, nearest);
        }
        else
        {
            _coverage.AddChord(sample.Place, sample.Place, nearest); // a lone sample is a dot
        }

        _wasOff = isOff;
    }

    /// <summary>Where it leads from one segment to another there may be shorter ones between them.</summary>
    private void AddChord(Point2D from, Point2D to, int nearest)
    {
        if (nearest != _coverage.Followed)
        {
            var (chord, steps) = (Segment.FromLine(from, to), Math.Min(MostStepsOfChord, (int)Math.Ceiling(from.DistanceTo(to) / _reach)));
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

/// <summary>What a trace says about a run, lengths in millimetres.</summary>
/// <param name="CuttingSamples">Samples with the tool on; with none, nothing is known of the deviation.</param>
/// <param name="MaxDeviation">Largest distance of a cutting sample from the drawing; 0 without cutting samples, infinite when something was cut and the drawing is empty.</param>
/// <param name="DeviationAt">The sample that deviates most; null without cutting samples.</param>
/// <param name="MissingLength">Length of the drawing that was never cut.</param>
/// <param name="MissingAt">A place in the first gap of the drawing; null when nothing is missing.</param>
/// <param name="ExtraLength">Length that was cut beside the drawing: between consecutive cutting samples of which one lies off it by more than the coverage tolerance.</param>
public sealed record TraceVerdict(
    long CuttingSamples, double MaxDeviation, TraceSample? DeviationAt, double MissingLength, Point2D? MissingAt, double ExtraLength);

/// <summary>Compares what a machine did with a drawing while it is told: in plan (<see cref="TraceJudge"/>), or in three coordinates (<see cref="HeightJudge"/>).</summary>
public interface ITraceJudge
{
    /// <summary>The machine was here; between two consecutive cutting samples it went straight.</summary>
    void Add(in TraceSample sample);

    /// <summary>The machine went along here.</summary>
    void Add(in TraceSpan span);

    /// <summary>What is known so far; with no more to come, the verdict.</summary>
    TraceVerdict Verdict();
}
