using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>Compares a run with its drawing while the run goes on: takes the drawing once, then samples and spans in order of time. Memory grows with the drawing, time with the number of samples and spans.</summary>
/// <remarks>Results are defined as in <see cref="TraceComparison.Compare"/>. Not thread safe.</remarks>
public sealed class TraceJudge
{
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
    /// <param name="tolerances">What counts as cut, and which gaps do not count.</param>
    public TraceJudge(IReadOnlyList<Segment> drawing, TraceTolerances tolerances)
    {
        ArgumentNullException.ThrowIfNull(tolerances);
        Segment[] pieces = [.. CurvePieces.Split(drawing)];
        _reach = tolerances.Coverage;
        _index = new SegmentIndex(pieces, segment => DrawnCoverage.Crossed(segment, tolerances));
        _spans = new SpanDeviation(pieces, _index, tolerances);
        _coverage = new DrawnCoverage(pieces, _index, tolerances);
    }

    /// <summary>Takes one position of the machine; between two consecutive cutting samples it moved straight.</summary>
    public void Add(in TraceSample sample)
    {
        if (sample.Cutting)
        {
            _samples++;
            Judge(sample);
        }

        _last = sample;
    }

    /// <summary>Takes a span of motion.</summary>
    public void Add(in TraceSpan span)
    {
        if (span.Cutting)
        {
            _samples += span.Samples;
            Judge(span.At(0.0));
            var found = _spans.Measure(span, _largest);
            if (found.Largest > _largest) (_largest, _worst) = (found.Largest, span.At(found.At));
            _extra += found.Extra;
            _coverage.Add(span.Path);
            _index.NearEnoughTo(span.Path.End, _reach, out var atEnd);
            _wasOff = atEnd > _reach;
        }

        _last = span.At(1.0);
    }

    /// <summary>The result so far; after the last sample, the verdict.</summary>
    public TraceVerdict Verdict()
    {
        var (missing, at) = _coverage.Missing();
        return new TraceVerdict(_samples, _largest, _worst, missing, at, _extra);
    }

    private void Judge(in TraceSample sample)
    {
        _index.NearEnoughTo(sample.Place, Math.Min(_largest, _reach), out var deviation);
        if (_worst is null || deviation > _largest) (_largest, _worst) = (deviation, sample);
        var isOff = deviation > _reach;
        if (_last is { Cutting: true } before)
        {
            if (isOff || _wasOff) _extra += before.Place.DistanceTo(sample.Place);
            if (before.Place != sample.Place) _coverage.AddChord(before.Place, sample.Place);
        }
        else
        {
            _coverage.AddChord(sample.Place, sample.Place); // a single sample is a dot
        }

        _wasOff = isOff;
    }
}

/// <summary>What a trace says about a run, lengths in millimetres.</summary>
/// <param name="CuttingSamples">Samples with the tool on; without any, the deviation is unknown.</param>
/// <param name="MaxDeviation">Largest distance of a cutting sample from the drawing; 0 without cutting samples, infinite when something was cut and the drawing is empty.</param>
/// <param name="DeviationAt">The sample that deviates most; null without cutting samples.</param>
/// <param name="MissingLength">Length of the drawing that was never cut.</param>
/// <param name="MissingAt">A point in the first gap of the drawing; null when nothing is missing.</param>
/// <param name="ExtraLength">Length that was cut beside the drawing: between consecutive cutting samples of which one is farther from it than the coverage tolerance.</param>
public sealed record TraceVerdict(
    long CuttingSamples, double MaxDeviation, TraceSample? DeviationAt, double MissingLength, Point2D? MissingAt, double ExtraLength);
