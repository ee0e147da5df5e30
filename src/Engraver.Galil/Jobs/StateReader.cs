using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>Reads the machine's state: all of it, or on a serial line only what the path does.</summary>
/// <param name="followed">Letters of the axes whose position error is read as well; empty for none.</param>
internal sealed class StateReader(ControllerSession session, MachineAxes axes, string followed, JobCommands commands, StopOrder order)
{
    /// <summary>Readings of the path between two whole readings, on a serial line.</summary>
    internal const int GlancesBetweenPolls = 8;

    private static readonly TimeSpan s_betweenErrors = TimeSpan.FromMilliseconds(100);

    /// <summary>On a serial line the query takes the time of a segment or two.</summary>
    private static readonly TimeSpan s_betweenErrorsOnALine = TimeSpan.FromSeconds(1);

    private readonly StateQuestions _questions = new(axes, isSlow: session.Line is not null, followed);
    private readonly PollTimes _times = new(session.Time, (session.Identity.Limits.SampleMicroseconds ?? 1000) / 1e6);
    private long? _errorAsked;
    private int _glances;

    /// <summary>The last reading; null before the first.</summary>
    public JobPoll? Known { get; private set; }

    /// <summary>The last reading.</summary>
    public JobPoll State => Known ?? throw new InvalidOperationException("The machine was not polled yet.");

    /// <summary>Time since the last reading.</summary>
    public TimeSpan SincePoll => _times.SincePoll;

    /// <summary>Controller time from the first reading to the last.</summary>
    public double Seconds => _times.Seconds;

    /// <summary>Reads the whole state.</summary>
    public async ValueTask ReadAsync()
    {
        await ReadWholeAsync().ConfigureAwait(false);
        await EndReadingAsync().ConfigureAwait(false);
    }

    /// <summary>Reads only what the path does where a whole reading would delay the segments: on a serial line.</summary>
    /// <param name="isWhole">Something needs a whole reading.</param>
    public async ValueTask GlanceAsync(bool isWhole)
    {
        if (session.Line is null || Known is null || isWhole || ++_glances % GlancesBetweenPolls == 0) await ReadWholeAsync().ConfigureAwait(false);
        else await ReadPathAsync().ConfigureAwait(false);
        await EndReadingAsync().ConfigureAwait(false);
    }

    private async ValueTask ReadPathAsync()
    {
        var withErrors = _glances % GlancesBetweenPolls == GlancesBetweenPolls / 2 ? _questions.MotionWithErrors : null;
        await ReadAsync(withErrors ?? _questions.Motion).ConfigureAwait(false);
        if (withErrors is not null && !State.SequenceRunning) await ReadAsync(_questions.Motion).ConfigureAwait(false); // why it ended

        // The axes were last seen in motion because of the path: when it has ended they must be read again.
        if (!State.SequenceRunning && State.AxesRunning) await ReadWholeAsync().ConfigureAwait(false);
    }

    private async ValueTask ReadWholeAsync()
    {
        foreach (var question in _questions.Whole) await ReadAsync(question).ConfigureAwait(false);
    }

    private async ValueTask ReadAsync(StateQuestion question) => Known = question.Update(Known ?? default, await commands.AskAllAsync(question).ConfigureAwait(false));

    /// <summary>Notes the time, and queries _TE of the axes that have one (galil-dmc.md A.10) when it is due: in a line of its own, because a whole
    /// reading is as long as a line may be.</summary>
    private async ValueTask EndReadingAsync()
    {
        _times.Polled(State.Time);
        if (State.Error is not null) _errorAsked = session.Time.GetTimestamp();
        if (_questions.Errors is not { } errors || order.IsPressed || State.Error is not null) return;
        if (_errorAsked is { } asked && session.Time.GetElapsedTime(asked) < (session.Line is null ? s_betweenErrors : s_betweenErrorsOnALine)) return;
        _errorAsked = session.Time.GetTimestamp();
        await ReadAsync(errors).ConfigureAwait(false);
    }
}
