using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Motion;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts;

/// <summary>Measures the time of every move of a program that a controller runs, and of every wait before a move: feeds, rapid speeds, accelerations and settle
/// times affect them, independent of the commands that set them.</summary>
/// <remarks>The samples are those of the controller: a move has a position in every sample, a longer gap is a wait. A switch also ends a move: without a settle
/// time the next one begins in the same sample.</remarks>
public sealed class ScheduleJudge : ITraceJudge
{
    /// <summary>Largest time between two samples of a moving controller, seconds.</summary>
    private const double Step = 0.0015;

    /// <summary>Tolerance of the time of a move: a fraction of it, plus the samples in which it starts and ends; seconds.</summary>
    private const double MoveShare = 0.005;
    private const double MoveSlack = 0.003;

    /// <summary>Additional tolerance of the time of a move, seconds for each segment and at most a fraction of the time: before a sharp turn the plan is slow
    /// for a sample and a quarter in which the controller's brake may end.</summary>
    private const double TurnSeconds = 0.00125;
    private const double TurnShare = 0.02;

    /// <summary>Tolerance of a wait: a fraction of it, plus the statements of the program around it; seconds.</summary>
    private const double WaitShare = 0.03;
    private const double WaitSlack = 0.025;

    /// <summary>Additional time at rest for each segment that is loaded before motion, seconds: a statement of the controller and its surrounding
    /// code.</summary>
    private const double LoadSeconds = 0.001;

    private readonly List<ScheduledMove> _moves = [];
    private readonly Dictionary<int, ScheduledMove> _lasts = [];
    private TraceSample? _last;
    private double _began;
    private double _length;
    private double _rest;
    private double? _switched;
    private double? _waitsFrom;

    public void Add(in TraceSample sample)
    {
        Go(sample);
        _last = sample;
    }

    public void Add(in TraceSpan span)
    {
        Go(span.At(0.0));
        _length += span.Path.Length;
        _last = span.At(1.0);
    }

    /// <summary>The parts started so far.</summary>
    public ProgramParts Parts => new(_lasts);

    /// <summary>The machine is at rest and a further part of the program is about to run.</summary>
    public void BeginPart()
    {
        Rest();
        if (_moves.Count > 0) _lasts[_moves.Count] = _moves[^1];
    }

    public TraceVerdict Verdict() => throw new NotSupportedException("A pace alone is no verdict.");

    /// <summary>Null when the times match the job in one of the several ways in which it can be posted; otherwise the first move with a different time, or with
    /// a different wait before it.</summary>
    /// <param name="ways">The moves of each way, at least one way, divided in <see cref="Parts"/>.</param>
    public Diagnostic? Finding(IReadOnlyList<IReadOnlyList<ScheduledMove>> ways)
    {
        ArgumentNullException.ThrowIfNull(ways);
        Rest();
        var findings = ways.OrderByDescending(way => way.Count == _moves.Count).Select(Difference).ToList();
        return findings.Contains(null) ? null : findings[0];
    }

    /// <summary>A surplus or missing move is compared with a move of zero time.</summary>
    private Diagnostic? Difference(IReadOnlyList<ScheduledMove> expected)
    {
        for (var i = 0; i < Math.Max(expected.Count, _moves.Count); i++)
        {
            var (found, asked) = (_moves.ElementAtOrDefault(i), expected.ElementAtOrDefault(i));
            if (!IsMove(found, asked) || ((i > 0 || found.Segments == 0) && !IsWait(found, asked))) return Other(found, asked, i < _moves.Count ? found.End : asked.End);
        }

        return null;
    }

    /// <summary>The time from the switch to the move when the tool was switched, otherwise the whole time at rest.</summary>
    /// <param name="found">Includes segments when the whole time at rest was measured, during which they were loaded.</param>
    private static bool IsWait(ScheduledMove found, ScheduledMove asked) =>
        found.Wait >= (asked.Wait * (1.0 - WaitShare)) - WaitSlack && found.Wait <= (asked.Wait * (1.0 + WaitShare)) + WaitSlack + (found.Segments > 0 ? LoadSeconds * asked.Segments : 0.0);

    private static bool IsMove(ScheduledMove found, ScheduledMove asked) =>
        Math.Abs(found.Seconds - asked.Seconds) <= (MoveShare * asked.Seconds) + MoveSlack + Math.Min(TurnSeconds * asked.Segments, TurnShare * asked.Seconds);

    private static Diagnostic Other(ScheduledMove found, ScheduledMove asked, Point2D end) =>
        VerificationRules.OtherPace.At(default, FactText.Of(end.X, 3), FactText.Of(end.Y, 3), FactText.Of(found.Seconds, 3), FactText.Of(found.Wait, 3), FactText.Of(asked.Seconds, 3), FactText.Of(asked.Wait, 3)) with { Place = end };

    /// <summary>A move from the last position to this one, or a rest between them.</summary>
    private void Go(in TraceSample next)
    {
        if (_last is not { } last)
        {
            (_began, _rest) = (next.Seconds, next.Seconds);
            return;
        }

        var (isSwitched, isRested, way) = (next.Cutting != last.Cutting, next.Seconds - last.Seconds > Step, last.Place.DistanceTo(next.Place));
        if (isSwitched) _switched = next.Seconds;
        if (!isSwitched && !isRested)
        {
            _length += way;
            return;
        }

        Rest();
        (_length, _began) = isRested ? (0.0, next.Seconds) : (way, last.Seconds);
        _waitsFrom = _switched is { } at && at >= _rest ? Math.Min(at, _began) : null;
    }

    /// <summary>Ends the current move at rest; switching an output at rest is not a move, nor is a move to the present position.</summary>
    private void Rest()
    {
        if (_last is not { } last || !(_length > 0.0)) return;
        _moves.Add(new ScheduledMove(last.Seconds - _began, _began - (_waitsFrom ?? _rest), last.Place) { Segments = _waitsFrom is null ? 1 : 0 });
        (_rest, _began, _waitsFrom, _length) = (last.Seconds, last.Seconds, null, 0.0);
    }
}
