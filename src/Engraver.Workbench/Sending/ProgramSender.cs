using Engraver.Core.Languages;
using Engraver.Core.Sending;

namespace Engraver.Workbench.Sending;

/// <summary>Sends a program over a serial line as plain characters, no faster than the line carries them, so that the other side's XOFF is obeyed within a
/// few characters and a stop knows how much is out.</summary>
public sealed class ProgramSender
{
    /// <summary>Characters that are handed to the line at once: what may still come after an XOFF. Controls of punched tape expect up to 16 and more.</summary>
    private const int Chunk = 8;

    private static readonly TimeSpan s_moment = TimeSpan.FromMilliseconds(5);

    private readonly IProgramLine _line;
    private readonly SendPace _pace;
    private readonly TimeProvider _time;
    private readonly FlowGate _gate;
    private TimeSpan _due;
    private long _begun;
    private long _characters;
    private int _lines;

    private ProgramSender(IProgramLine line, SendPace pace, TimeProvider time)
    {
        (_line, _pace, _time) = (line, pace, time);
        _gate = new FlowGate(line, pace.Frame, pace.ObeysXoff);
    }

    /// <summary>Sends everything.</summary>
    /// <returns>How it ended; a stop, a line that is gone and one that is held for too long are ends too.</returns>
    public static Task<SendResult> SendAsync(IProgramLine line, SendJob job, SendPace pace, IProgress<SendProgress>? progress, TimeProvider time, CancellationToken stop)
    {
        ArgumentNullException.ThrowIfNull(line);
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(pace);
        ArgumentNullException.ThrowIfNull(time);
        return new ProgramSender(line, pace, time).RunAsync(job, progress, stop);
    }

    private async Task<SendResult> RunAsync(SendJob job, IProgress<SendProgress>? progress, CancellationToken stop)
    {
        _begun = _time.GetTimestamp();
        using var listening = new CancellationTokenSource();
        var ears = _gate.ListenAsync(listening.Token);
        try
        {
            await SendAllAsync(job, progress, stop).ConfigureAwait(false);
            await _line.DrainAsync(stop).ConfigureAwait(false);
            return Result(SendOutcome.Complete, job, null);
        }
        catch (OperationCanceledException) when (stop.IsCancellationRequested)
        {
            return Result(SendOutcome.Stopped, job, null);
        }
        catch (TimeoutException held)
        {
            return Result(SendOutcome.HeldTooLong, job, held.Message);
        }
        catch (IOException gone)
        {
            return Result(SendOutcome.LinkLost, job, SystemReason.Of(gone));
        }
        finally
        {
            await listening.CancelAsync().ConfigureAwait(false);
            await ears.ConfigureAwait(false);
        }
    }

    private SendResult Result(SendOutcome outcome, SendJob job, string? reason) =>
        new(outcome, _lines, job.Lines.Count, _characters, _gate.Holds, _gate.Others, _time.GetElapsedTime(_begun).TotalSeconds, reason);

    private async Task SendAllAsync(SendJob job, IProgress<SendProgress>? progress, CancellationToken stop)
    {
        await SendAsync(job.Leader, stop).ConfigureAwait(false);
        foreach (var line in job.Lines)
        {
            await SendAsync(line, stop).ConfigureAwait(false);
            _lines++;
            progress?.Report(new SendProgress(_lines, job.Lines.Count, _characters, _gate.Holds));
            await WaitAsync(_pace.LineDelay, stop).ConfigureAwait(false);
        }

        await SendAsync(job.Trailer, stop).ConfigureAwait(false);
        await OpenAsync(stop).ConfigureAwait(false);
    }

    private async Task SendAsync(ReadOnlyMemory<byte> bits, CancellationToken stop)
    {
        var most = _pace.CharacterDelay > TimeSpan.Zero ? 1 : Chunk;
        while (!bits.IsEmpty)
        {
            await OpenAsync(stop).ConfigureAwait(false);
            var now = bits[..Math.Min(most, bits.Length)];
            await _line.WriteAsync(now, stop).ConfigureAwait(false);
            await WaitAsync((_pace.CharacterTime + _pace.CharacterDelay) * now.Length, stop).ConfigureAwait(false);
            _characters += now.Length;
            bits = bits[now.Length..];
        }
    }

    /// <summary>Waits while the other side wants us to.</summary>
    /// <exception cref="TimeoutException">It does not let us go on.</exception>
    private async Task OpenAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var open = _gate.OpenAsync();
        if (open.IsCompleted) return;
        try
        {
            await open.WaitAsync(_pace.LongestHold, _time, stop).ConfigureAwait(false);
        }
        catch (TimeoutException never)
        {
            throw new TimeoutException(Wording.Get("ProgramSender.XoffTimeout", _pace.LongestHold.TotalSeconds), never);
        }
    }

    /// <summary>Lets time pass by the line's own clock: timers that ring late do not make the whole slower, and what was missed by more than a moment is
    /// not caught up in a burst.</summary>
    private async Task WaitAsync(TimeSpan span, CancellationToken stop)
    {
        var now = _time.GetElapsedTime(_begun);
        _due = (_due < now - s_moment ? now : _due) + span;
        if (_due > now) await Task.Delay(_due - now, _time, stop).ConfigureAwait(false);
    }
}

/// <summary>How fast a program goes out, and what makes it wait.</summary>
/// <param name="Frame">Of the characters that come back.</param>
/// <param name="CharacterTime">On the line.</param>
public sealed record SendPace(CharacterFrame Frame, TimeSpan CharacterTime)
{
    /// <summary>Pause behind every character, beside its own time.</summary>
    public TimeSpan CharacterDelay { get; init; }

    /// <summary>Pause behind every line.</summary>
    public TimeSpan LineDelay { get; init; }

    /// <summary>XOFF and XON are obeyed.</summary>
    public bool ObeysXoff { get; init; } = true;

    /// <summary>How long the other side may make us wait at a time.</summary>
    public TimeSpan LongestHold { get; init; } = TimeSpan.FromSeconds(60);
}

/// <summary>How far it is.</summary>
public sealed record SendProgress(int Lines, int AllLines, long Characters, int Holds);

/// <summary>How the sending ended.</summary>
/// <param name="Lines">Lines of the program that are out whole.</param>
/// <param name="Characters">Everything that is out, leader and line ends included.</param>
/// <param name="Holds">How often XOFF was heard.</param>
/// <param name="Heard">Characters that came back beside XON and XOFF.</param>
/// <param name="Reason">Why it did not come to its end, a sentence; null when it did or was stopped.</param>
public sealed record SendResult(SendOutcome Outcome, int Lines, int AllLines, long Characters, int Holds, long Heard, double Seconds, string? Reason);

public enum SendOutcome : byte
{
    Complete,

    /// <summary>By the operator.</summary>
    Stopped,

    LinkLost,

    /// <summary>The other side sent XOFF and no XON in time.</summary>
    HeldTooLong,
}
