using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Cli.Terminals;

/// <summary>The keys of a terminal while <c>engraver run</c> runs a job: feed hold, resume, overrides, and jog steps while held. They are polled with every
/// progress report of the job; the operator's stop is Ctrl-C.</summary>
/// <param name="control">Control of the job.</param>
/// <param name="scale">Scale of the machine, for steps.</param>
/// <param name="next">The next pressed key; null when there is none.</param>
/// <param name="say">Reports the effect of a key to the operator.</param>
internal sealed class RunKeys(JobControl control, CountsScale scale, Func<ConsoleKeyInfo?> next, Action<string> say) : IProgress<JobProgress>
{
    /// <summary>Change of an override by one key press, a factor of the planned speed.</summary>
    private const double Step = 0.1;

    private const double Percent = 100.0;

    /// <summary>Distance that an arrow key moves a held machine, mm.</summary>
    private const double JogStep = 1.0;

    private JobPhase _lastPhase;
    private double _limit = 1.0;
    private Task<JobResult>? _move;

    public void Report(JobProgress value)
    {
        while (next() is { } key) Press(key);
        if (_move is { IsCompletedSuccessfully: true, Result: var moved })
        {
            _move = null;
            say(moved is { Outcome: JobOutcome.Complete, FinalPosition: { } at } ? Wording.Get("RunKeys.Moved", PositionText.Format(at, scale)) : moved.Message);
        }

        ReportLimit(value.FeedRatio);
        if (value.Phase == _lastPhase) return;
        _lastPhase = value.Phase;
        if (value.Phase == JobPhase.Held) say(Wording.Get("RunKeys.Held"));
    }

    /// <summary>Reports when the feed in force is below the requested one.</summary>
    private void ReportLimit(double inForce)
    {
        var limit = inForce < control.FeedRatio ? inForce : 0.0;
        if (limit > 0.0 && limit != _limit && inForce >= 1.0) say(Wording.Get("RunKeys.Limited", limit * Percent));
        _limit = limit;
    }

    private void Press(ConsoleKeyInfo key)
    {
        if (StepOf(key.Key) is { } step)
        {
            if (_move is null) _move = control.MoveAsync(MoveInHold.By(step));
            return;
        }

        switch (key.KeyChar)
        {
            case 'h' or 'H': control.Hold(); break;
            case 'r' or 'R': control.Resume(); break;
            case '+' or '=': Feed(control.FeedRatio + Step); break;
            case '-' or '_': Feed(control.FeedRatio - Step); break;
            case '>' or '.': Rapid(control.RapidRatio + Step); break;
            case '<' or ',': Rapid(control.RapidRatio - Step); break;
            case '0': Feed(1.0); break;
        }
    }

    private CountsPoint? StepOf(ConsoleKey key) => key switch
    {
        ConsoleKey.LeftArrow => Counts(-JogStep, 0.0),
        ConsoleKey.RightArrow => Counts(JogStep, 0.0),
        ConsoleKey.UpArrow => Counts(0.0, JogStep),
        ConsoleKey.DownArrow => Counts(0.0, -JogStep),
        _ => null,
    };

    private CountsPoint Counts(double x, double y) => scale.ToCounts(new Point2D(x, y));

    private void Feed(double ratio)
    {
        control.FeedRatio = Math.Round(ratio, 2);
        ReportOverride();
    }

    private void Rapid(double ratio)
    {
        control.RapidRatio = Math.Round(ratio, 2);
        ReportOverride();
    }

    private void ReportOverride() => say(Wording.Get("RunKeys.Override", control.FeedRatio * Percent, control.RapidRatio * Percent));
}
