using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Motion;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts;

/// <summary>Takes the time of every move of a program that is run by a controller, and of every wait before one: feeds, rapid speeds, accelerations and settle times show in them, whatever commands they were said with.</summary>
/// <remarks>The samples that are told are those of the controller: a move is what has one in every sample, a longer gap is a wait.</remarks>
public sealed class PaceJudge : ITraceJudge
{
    /// <summary>Two samples of a controller that moves lie no farther apart, seconds.</summary>
    private const double Step = 0.0015;

    /// <summary>What a move may take more or less: a part of it, and the samples in which it begins and ends; seconds.</summary>
    private const double MoveShare = 0.005;
    private const double MoveSlack = 0.003;

    /// <summary>What a wait may be longer or shorter: a part of it, and the statements of the program around it; seconds.</summary>
    private const double WaitShare = 0.03;
    private const double WaitSlack = 0.025;

    /// <summary>By how much longer it stands for each segment that is loaded before it moves, seconds: a statement of the controller and what is around it.</summary>
    private const double LoadSeconds = 0.001;

    private readonly List<PaceMove> _moves = [];
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

    public TraceVerdict Verdict() => throw new NotSupportedException("A pace alone is no verdict.");

    /// <summary>Null where the times are those of the job as it may have been posted in one of several ways; otherwise the first move that takes another time, or begins after another wait.</summary>
    /// <param name="ways">The moves of each way, at least one way. Those with as many moves as the program has decide; a program that was cut in parts has other moves, and then the sums of times are compared.</param>
    public Diagnostic? Finding(IReadOnlyList<IReadOnlyList<PaceMove>> ways)
    {
        ArgumentNullException.ThrowIfNull(ways);
        Rest();
        var equal = ways.Where(way => way.Count == _moves.Count).ToList();
        var findings = (equal.Count > 0 ? equal.Select(Each) : ways.Select(Whole)).ToList();
        return findings.Contains(null) ? null : findings[0];
    }

    private Diagnostic? Each(IReadOnlyList<PaceMove> expected)
    {
        for (var i = 0; i < expected.Count; i++)
        {
            var (found, asked) = (_moves[i], expected[i]);
            if (!IsNear(found.Seconds, asked.Seconds, MoveShare, MoveSlack) || ((i > 0 || found.Segments == 0) && !IsWait(found, asked))) return Other(found, asked);
        }

        return null;
    }

    private Diagnostic? Whole(IReadOnlyList<PaceMove> expected)
    {
        var (found, asked) = (_moves.Sum(move => move.Seconds), expected.Sum(move => move.Seconds));
        var (waits, askedWaits, most) = (_moves.Skip(1).Sum(move => move.Wait), expected.Skip(1).Sum(move => move.Wait), Math.Max(_moves.Count, expected.Count));
        var isNear = IsNear(found, asked, MoveShare, MoveSlack * most) && IsNear(waits, askedWaits, WaitShare, (WaitSlack * most) + (LoadSeconds * expected.Sum(move => move.Segments)));
        return isNear ? null : Other(new PaceMove(found, waits, default), new PaceMove(asked, askedWaits, default));
    }

    /// <summary>From the switch to the move where the tool was switched, otherwise all of the time at rest.</summary>
    /// <param name="found">With segments where the whole time at rest was taken, in which they were loaded.</param>
    private static bool IsWait(PaceMove found, PaceMove asked) =>
        found.Wait >= (asked.Wait * (1.0 - WaitShare)) - WaitSlack && found.Wait <= (asked.Wait * (1.0 + WaitShare)) + WaitSlack + (found.Segments > 0 ? LoadSeconds * asked.Segments : 0.0);

    private static bool IsNear(double found, double asked, double share, double slack) => Math.Abs(found - asked) <= (share * asked) + slack;

    private static Diagnostic Other(PaceMove found, PaceMove asked) =>
        VerificationRules.OtherPace.At(default, Text(found.End.X), Text(found.End.Y), Text(found.Seconds), Text(found.Wait), Text(asked.Seconds), Text(asked.Wait)) with { Place = found.End };

    private static string Text(double value) => FactText.Of(Math.Round(value, 3));

    /// <summary>From the last place to this one, or a rest between them.</summary>
    private void Go(in TraceSample next)
    {
        if (_last is not { } last)
        {
            (_began, _rest) = (next.Seconds, next.Seconds);
            return;
        }

        if (next.Cutting != last.Cutting) _switched = next.Seconds;
        if (next.Seconds - last.Seconds <= Step)
        {
            _length += last.Place.DistanceTo(next.Place);
            return;
        }

        Rest();
        _length = 0.0;
        (_began, _waitsFrom) = (next.Seconds, _switched is { } at && at >= _rest ? at : null);
    }

    /// <summary>What moved since it began has come to rest; switching an output at rest is no move, nor is going to where the machine stands.</summary>
    private void Rest()
    {
        if (_last is not { } last || !(_length > 0.0)) return;
        _moves.Add(new PaceMove(last.Seconds - _began, _began - (_waitsFrom ?? _rest), last.Place) { Segments = _waitsFrom is null ? 1 : 0 });
        (_rest, _began, _waitsFrom, _length) = (last.Seconds, last.Seconds, null, 0.0);
    }
}
