using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Verification;

/// <summary>Compares every pass of a job with its own nominal path only, and not with those beside, above and below it. A stroke is recognised when the tool
/// comes down: by the order of cutting and by its start.</summary>
/// <remarks>It needs every sample: where a position with the tool up was not recorded, two strokes are one. Not thread safe.</remarks>
public sealed class PassJudge : ITraceJudge
{
    private readonly IReadOnlyList<JudgedStroke> _strokes;
    private readonly Pass[] _passes;
    private readonly double _near;
    private int _stroke = -1;
    private bool _isCutting;
    private bool _wasRaised;
    private Point2D? _found;
    private TraceSample? _raised;

    /// <param name="strokes">In the order of cutting.</param>
    /// <param name="judgeOf">Creates the judge of the moves of a pass.</param>
    /// <param name="near">A place within this distance of a stroke is on it, mm.</param>
    public PassJudge(IReadOnlyList<JudgedStroke> strokes, Func<IReadOnlyList<StrokeMove>, ITraceJudge> judgeOf, double near)
    {
        ArgumentNullException.ThrowIfNull(strokes);
        ArgumentNullException.ThrowIfNull(judgeOf);
        (_strokes, _near) = (strokes, near);
        _passes = [.. strokes.GroupBy(stroke => stroke.Pass).OrderBy(pass => pass.Key).Select(pass => new Pass(judgeOf([.. pass.SelectMany(stroke => stroke.Moves)])))];
    }

    public void Add(in TraceSample sample)
    {
        if (!sample.Cutting || IsFirstRaise(sample))
        {
            if (_isCutting) _passes[_strokes[_stroke].Pass].Leave(sample);
            _isCutting = false;
            if (!sample.Cutting) (_wasRaised, _raised) = (true, sample);
            return;
        }

        if (!_isCutting) Enter(sample.Place);
        _passes[_strokes[_stroke].Pass].Add(sample, _strokes[_stroke].HasOther(sample.Outputs));
    }

    public void Add(in TraceSpan span)
    {
        if (!span.Cutting)
        {
            Add(span.At(1.0));
            return;
        }

        if (!_isCutting) Enter(span.Path.Start);
        _passes[_strokes[_stroke].Pass].Add(span, _strokes[_stroke].HasOther(span.Outputs));
    }

    /// <summary>What was added before was cut by an earlier run: it is not measured.</summary>
    public void BeginRun()
    {
        (_isCutting, _wasRaised, _found, _raised) = (false, false, null, null);
        foreach (var pass in _passes) pass.BeginRun();
    }

    /// <summary>The largest deviation and the sums of all passes.</summary>
    public TraceVerdict Verdict()
    {
        List<TraceVerdict> all = [.. _passes.Select(pass => pass.Verdict())];
        var worst = all.MaxBy(one => one.MaxDeviation);
        return new TraceVerdict(all.Sum(one => one.CuttingSamples), worst?.MaxDeviation ?? 0.0, worst?.DeviationAt, all.Sum(one => one.MissingLength), all.Select(one => one.MissingAt).FirstOrDefault(place => place is not null), all.Sum(one => one.ExtraLength)) { CornerDeviation = all.Max(one => one.CornerDeviation) };
    }

    /// <summary>What was measured of each pass; null where it was not cut in this run.</summary>
    public IReadOnlyList<MeasuredPass?> Measured() => [.. _passes.Select(pass => pass.Measured())];

    /// <summary>True until the tool is up for the first time, at its initial place: it is raised from its initial position, on or in the work.</summary>
    private bool IsFirstRaise(in TraceSample sample)
    {
        _found ??= sample.Place;
        return !_wasRaised && sample.Place == _found;
    }

    /// <summary>The tool comes down: at the start of the next stroke, in the present one after a hold, or at the start of a later one.</summary>
    private void Enter(Point2D place)
    {
        var next = _stroke + 1;
        if (!(next < _strokes.Count && StartsAt(next, place)) && !(_stroke >= 0 && _strokes[_stroke].Moves.Any(move => move.Segment.DistanceTo(place) <= _near)))
        {
            while (next < _strokes.Count && !StartsAt(next, place)) next++;
            if (next == _strokes.Count) next = Math.Max(0, _stroke);
        }
        else if (next == _strokes.Count || !StartsAt(next, place)) next = _stroke;

        (_stroke, _isCutting) = (next, true);
        if (_raised is { } before) _passes[_strokes[_stroke].Pass].Leave(before);
    }

    private bool StartsAt(int stroke, Point2D place) => _strokes[stroke].Moves[0].Segment.Start.DistanceTo(place) <= _near;

    /// <summary>One pass of one operation.</summary>
    private sealed class Pass(ITraceJudge judge)
    {
        /// <summary>A speed is measured over at least this time, seconds: the positions of two samples are whole counts.</summary>
        private const double Window = 0.1;

        private long _samples;
        private long _outputFaults;
        private double _lowest = double.PositiveInfinity;
        private double _fastest;
        private TraceSample? _last;
        private (double Seconds, double Length)? _window;

        public void Add(in TraceSample sample, bool hasOtherOutputs)
        {
            judge.Add(sample);
            _samples++;
            if (hasOtherOutputs) _outputFaults++;
            _lowest = Math.Min(_lowest, sample.ZMm);
            Time(sample);
            _last = sample;
        }

        public void Add(in TraceSpan span, bool hasOtherOutputs)
        {
            judge.Add(span);
            _samples += span.Samples;
            if (hasOtherOutputs) _outputFaults += span.Samples;
            _lowest = Math.Min(_lowest, span.At(1.0).ZMm);
            if (span.ToSeconds - span.FromSeconds >= Window) _fastest = Math.Max(_fastest, span.Path.Length / (span.ToSeconds - span.FromSeconds));
            (_last, _window) = (null, null);
        }

        public void Leave(in TraceSample sample)
        {
            judge.Add(sample);
            (_last, _window) = (null, null);
        }

        public void BeginRun()
        {
            judge.BeginRun();
            (_samples, _outputFaults, _lowest, _fastest, _last, _window) = (0, 0, double.PositiveInfinity, 0.0, null, null);
        }

        public TraceVerdict Verdict() => judge.Verdict();

        public MeasuredPass? Measured()
        {
            if (_samples == 0) return null;
            var found = judge.Verdict();
            return new MeasuredPass(found.MaxDeviation, found.MissingLength, found.ExtraLength, -_lowest, _fastest == 0.0 ? null : _fastest * 60.0) { OutputFaults = _outputFaults, CornerDeviation = found.CornerDeviation };
        }

        /// <summary>Moves straight down and up are not the feed.</summary>
        private void Time(in TraceSample sample)
        {
            if (_last is not { } before || before.Place == sample.Place)
            {
                _window = null;
                return;
            }

            var (from, length) = _window ?? (before.Seconds, 0.0);
            length += double.Hypot(before.Place.DistanceTo(sample.Place), before.ZMm - sample.ZMm);
            var seconds = sample.Seconds - from;
            if (seconds >= Window) _fastest = Math.Max(_fastest, length / seconds);
            _window = seconds >= Window ? null : (from, length);
        }
    }
}
