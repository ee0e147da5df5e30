namespace Engraver.Core.Motion.Planning;

/// <summary>Plans the speed along the segments of one sequence, from rest to rest: the least time that its limits allow with one acceleration for speeding up
/// and braking.</summary>
/// <remarks>
/// A speed is bounded on a segment (feed; on an arc of radius r by v2/r) and at each joint. On an arc the acceleration along the path is added at a right
/// angle: it may be VA only up to the speed at which sqrt(VA2 + (v2/r)2) is the limit; faster, the speed of the whole arc is constant. The forward pass gives
/// the highest speed at each joint that can be reached from the start, the backward pass that from which the end can be reached; both maps are monotone, so
/// that the smaller of the two is the highest speed of any plan, and no plan with this VA takes less time. VA itself is chosen among a few parts of the
/// limit: less of it leaves more for arcs. All speeds that are commanded are even whole numbers.
/// </remarks>
public sealed class SpeedPlanner
{
    /// <summary>Parts of the largest acceleration that are tried for VA.</summary>
    private static readonly double[] s_parts = [1.0, 0.995, 0.98, 0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, LeastPart];

    private const double LeastPart = 0.3;

    /// <summary>Number of times that the search is continued halfway between the best part and those beside it.</summary>
    private const int Refinements = 2;

    /// <summary>A turn that the fastest path makes in this part of a sample does not count.</summary>
    private const double SmoothPart = 0.02;

    /// <summary>Samples for which a peak is held. A ramp ends within a sample: where the brake would begin in the same one, a part of the ramp would be
    /// missing.</summary>
    private const double HeldSamples = 1.5;

    /// <summary>A shorter part of a segment is not divided off, counts.</summary>
    private const double ShortestPart = 3.0;

    /// <summary>Speeds that differ by less are the same, counts/s.</summary>
    private const double SameSpeed = 2.0;

    /// <summary>Lengths that differ by less are the same, counts.</summary>
    private const double SameLength = 0.75;

    private readonly PathLimits _limits;
    private readonly int _step;
    private readonly List<double> _lengths = [];
    private readonly List<int> _feeds = [];

    /// <summary>Of arcs; infinite for a line. Whole counts up to 6,000,000 are exact.</summary>
    private readonly List<float> _radii = [];

    /// <summary>Largest acceleration along a line; for an arc in any direction. Empty where it is the same everywhere.</summary>
    private readonly List<double> _bounds = [];

    /// <summary>The turn before each segment, as <see cref="PathLimits.TurnOf"/>.</summary>
    private readonly List<double> _turns = [];
    private PathDirection _last;
    private double _fastest;

    /// <summary>While it is planned squares of speeds: on a segment, up to which the speed may change on it, and at the joint before it. Once it is planned
    /// what is commanded: a speed from the start of each segment, the length before its end from which a second one holds, and that second speed or
    /// 0.</summary>
    private double[] _hold = [];
    private double[] _ramp = [];
    private double[] _joint = [];
    private double[] _speeds = [];

    /// <param name="limits">Of the machine.</param>
    /// <param name="step">VA is a multiple of this, counts/s2.</param>
    public SpeedPlanner(PathLimits limits, int step) => (_limits, _step) = (limits, step);

    /// <summary>Number of segments.</summary>
    public int Count => _lengths.Count;

    /// <summary>VA and VD of the plan, counts/s2.</summary>
    public int Acceleration { get; private set; }

    /// <summary>Seconds of the plan.</summary>
    public double Seconds { get; private set; }

    /// <summary>No plan for a machine has a smaller VA, counts/s2.</summary>
    /// <param name="step">VA is a multiple of this.</param>
    public static int LeastAcceleration(PathLimits limits, int step) => Whole(LeastPart * limits.OnArcs, step);

    /// <summary>Begins a sequence.</summary>
    public void Clear()
    {
        _lengths.Clear();
        _feeds.Clear();
        _radii.Clear();
        _bounds.Clear();
        _turns.Clear();
        _fastest = 0.0;
    }

    /// <summary>Appends a segment.</summary>
    /// <param name="length">Counts, above 0.</param>
    /// <param name="radius">Counts; infinite for a line.</param>
    /// <param name="feed">Largest speed, counts/s.</param>
    /// <param name="start">Direction at its start, as it is drawn.</param>
    /// <param name="end">Direction at its end.</param>
    public void Add(double length, double radius, double feed, PathDirection start, PathDirection end)
    {
        _turns.Add(Count == 0 ? 0.0 : _limits.TurnOf(_last, start));
        _lengths.Add(length);
        _radii.Add((float)radius);
        _feeds.Add((int)feed);
        if (HasBounds) _bounds.Add(double.IsInfinity(radius) ? _limits.Along(start) : _limits.OnArcs);
        _last = end;
        _fastest = Math.Max(_fastest, feed);
    }

    /// <summary>Largest speed of a segment, counts/s.</summary>
    public double FeedOf(int segment) => _feeds[segment];

    /// <summary>Limits the feed of each segment.</summary>
    /// <param name="speeds">Counts/s.</param>
    public void LimitTo(IReadOnlyList<int> speeds)
    {
        ArgumentNullException.ThrowIfNull(speeds);
        for (var i = 0; i < Count; i++) _feeds[i] = Math.Min(_feeds[i], speeds[i]);
    }

    /// <summary>Plans the segments since <see cref="Clear"/>.</summary>
    /// <param name="least">VA is not smaller, counts/s2; at most the limit.</param>
    public void Plan(int least = 0)
    {
        Reserve();
        MeasureHolds();
        (Seconds, Acceleration) = (double.PositiveInfinity, 0);
        if (!HasChoice()) Try(Whole(_limits.Total, _step));
        else Search(least);
        Run(Acceleration); // others were tried after it
        Command();
    }

    /// <summary>Less than the whole acceleration can be faster: there are arcs, or axes with bounds of their own.</summary>
    private bool HasChoice()
    {
        for (var i = 0; i < Count; i++)
        {
            if (BoundOf(i) < _limits.Total || !double.IsInfinity(RadiusOf(i))) return true;
        }

        return false;
    }

    private void Search(int least)
    {
        List<int> tried = [.. Candidates().Where(candidate => candidate >= Math.Min(least, Whole(_limits.Total, _step))).Order()];
        tried.ForEach(Try);
        for (var i = 0; i < Refinements && tried.Count > 1; i++)
        {
            var at = tried.IndexOf(Acceleration);
            List<int> between = [.. new[] { at - 1, at + 1 }.Where(beside => beside >= 0 && beside < tried.Count).Select(beside => (tried[at] + tried[beside]) / 2 / _step * _step).Where(halfway => halfway >= _step && !tried.Contains(halfway)).Distinct()];
            between.ForEach(Try);
            tried = [.. tried.Concat(between).Order()];
        }
    }

    /// <summary>Runs the sequence with a VA, and keeps the plan if it takes less time than those before.</summary>
    private void Try(int acceleration)
    {
        var seconds = Run(acceleration);
        if (seconds < Seconds) (Seconds, Acceleration) = (seconds, acceleration);
    }

    /// <summary>What is commanded for a segment of the plan: one speed from its start, or two with a place between them.</summary>
    public SegmentSpeeds SpeedsOf(int segment) => new((int)_hold[segment], (int)_joint[segment], _ramp[segment], _speeds[segment + 1]);

    /// <summary>Computes <see cref="SpeedsOf"/> for all segments, from the end to the start: a brake over several segments is commanded as one.</summary>
    private void Command()
    {
        var (target, isBraking) = (0, true); // after the last segment: the controller brakes to rest automatically
        for (var i = Count - 1; i >= 0; i--)
        {
            var (entry, exit, length) = (_speeds[i], _speeds[i + 1], _lengths[i]);
            var ramp = _ramp[i];
            var cap = Even(Math.Sqrt(ramp));
            if (entry * entry > ramp + 1.0) // an arc at constant speed
            {
                Command(i, Even(Math.Min(entry, exit)));
                isBraking = false;
                continue;
            }

            if (!isBraking) target = Even(exit);
            var peak = Math.Sqrt(Math.Min(ramp, ((entry * entry) + (exit * exit)) / 2.0 + (Acceleration * length)));
            var top = peak * peak < ramp - 1.0 ? Even(peak - Math.Min(HeldSamples * Acceleration * PathLimits.Sample, Math.Max(0.0, peak - Math.Max(entry, exit)) / 2.0)) : cap;
            var brake = SegmentSpeeds.BrakeOf(Math.Min(top, peak), exit, Acceleration);
            var isAutomatic = isBraking && target == 0;
            var isWhole = brake >= length - SameLength;
            if (peak - exit <= SameSpeed || isAutomatic) Command(i, cap);
            else if (brake < ShortestPart && !isWhole) Command(i, Even(exit));
            else if (isWhole || length < ShortestPart) Command(i, target);
            else Command(i, top, target, brake);
            isBraking = peak - exit > SameSpeed && isWhole && length >= ShortestPart;
            if (!isBraking) target = 0;
        }
    }

    private void Command(int segment, int first, int second = 0, double braking = 0.0) => (_hold[segment], _joint[segment], _ramp[segment]) = (first, second, braking);

    /// <summary>An axis has a bound of its own.</summary>
    private bool HasBounds => _limits.OnArcs < _limits.Total;

    private double BoundOf(int segment) => HasBounds ? _bounds[segment] : _limits.Total;

    private void Reserve()
    {
        if (_hold.Length >= Count + 1) return;
        var size = Math.Max(64, Count + 1 + (Count / 8));
        (_hold, _ramp, _joint, _speeds) = (new double[size], new double[size], new double[size], new double[size]);
    }

    /// <summary>Squares of the speeds that are allowed on each segment and at each joint, whatever VA is.</summary>
    private void MeasureHolds()
    {
        for (var i = 0; i < Count; i++)
        {
            var feed = Square(Even(_feeds[i]));
            _hold[i] = double.IsInfinity(_radii[i]) ? feed : Math.Min(feed, Square(Even(Math.Sqrt(BoundOf(i) * _radii[i]))));
            _joint[i] = i == 0 ? 0.0 : Square(Even(Math.Min(_fastest, _limits.SpeedThrough(_turns[i], Math.Min(_lengths[i - 1], _lengths[i])))));
        }
    }

    private IEnumerable<int> Candidates()
    {
        var (least, hasBends) = (double.PositiveInfinity, false);
        for (var i = 0; i < Count; i++)
        {
            least = Math.Min(least, BoundOf(i));
            hasBends |= !double.IsInfinity(RadiusOf(i)) && _hold[i] > 0.0;
        }

        var all = (hasBends ? s_parts : s_parts.AsSpan(0, 1).ToArray()).SelectMany(part => least < _limits.Total ? (double[])[part * _limits.Total, part * least] : [part * _limits.Total]);
        return all.Select(wanted => Whole(wanted, _step)).Distinct();
    }

    private static int Whole(double acceleration, int step) => Math.Max(step, (int)(acceleration / step) * step);

    /// <summary>Radius by which changes of the speed are bounded: that of an arc; for short lines with a turn at an end, which approximate one, that of the
    /// arc.</summary>
    private double RadiusOf(int segment)
    {
        var (radius, length) = (_radii[segment], _lengths[segment]);
        if (!double.IsInfinity(radius) || length > _limits.CloseTurns(_feeds[segment])) return radius;
        var turn = Math.Max(_turns[segment], segment + 1 < Count ? _turns[segment + 1] : 0.0);
        if (turn * _fastest <= SmoothPart * PathLimits.Sample || length > _limits.CloseTurns(Math.Min(_feeds[segment], _limits.SpeedThrough(turn, length)))) return radius;
        return length / (turn * _limits.Total);
    }

    /// <summary>Squares of the speeds up to which the speed of each segment may change at this VA.</summary>
    private void SetRamps(int acceleration)
    {
        for (var i = 0; i < Count; i++)
        {
            var bound = BoundOf(i);
            if (acceleration > bound * (1.0 + 1e-9))
            {
                _ramp[i] = 0.0;
                continue;
            }

            var radius = RadiusOf(i);
            _ramp[i] = double.IsInfinity(radius) ? _hold[i] : Math.Min(_hold[i], Square(Even(Math.Sqrt(radius * Math.Sqrt(Math.Max(0.0, (bound * bound) - ((double)acceleration * acceleration)))))));
        }
    }

    /// <summary>The plan with this VA in <see cref="_speeds"/>.</summary>
    /// <returns>Its seconds; infinite where the path cannot be run with it.</returns>
    private double Run(int acceleration)
    {
        SetRamps(acceleration);
        var twice = 2.0 * acceleration;
        var square = 0.0;
        for (var i = 0; i < Count; i++)
        {
            square = Math.Min(square, Math.Min(_joint[i], _hold[i]));
            _speeds[i] = square; // the highest from the start
            if (square <= _ramp[i]) square = Math.Min(_ramp[i], square + (twice * _lengths[i]));
        }

        (square, _speeds[Count]) = (0.0, 0.0);
        var seconds = 0.0;
        for (var i = Count - 1; i >= 0; i--)
        {
            var exit = _speeds[i + 1];
            if (square <= _ramp[i]) square = Math.Min(_ramp[i], square + (twice * _lengths[i]));
            square = Math.Min(Math.Min(square, _hold[i]), Math.Min(i == 0 ? 0.0 : _joint[i], _speeds[i]));
            var entry = Math.Sqrt(square);
            _speeds[i] = entry;
            seconds += TimeOf(entry, exit, _ramp[i], _lengths[i], acceleration);
        }

        return seconds;
    }

    private static double TimeOf(double entry, double exit, double ramp, double length, int acceleration)
    {
        if (entry * entry > ramp + 1.0) return length / entry;
        var middle = (((entry * entry) + (exit * exit)) / 2.0) + (acceleration * length);
        if (middle <= ramp) return ((2.0 * Math.Sqrt(middle)) - entry - exit) / acceleration;
        if (ramp <= 0.0) return double.PositiveInfinity;
        var peak = Math.Sqrt(ramp);
        return (((2.0 * peak) - entry - exit) / acceleration) + ((middle - ramp) / acceleration / peak);
    }

    /// <summary>The largest even whole number up to a value; 2 at least.</summary>
    private static int Even(double speed) => Math.Max(2, 2 * (int)((speed + 1e-6) / 2.0));

    private static double Square(double value) => value * value;
}
