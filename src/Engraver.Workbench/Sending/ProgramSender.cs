using Engraver.Core.Languages;
using Engraver.Core.Sending;

namespace Engraver.Workbench.Sending;

/// <summary>Sends a program over a serial line as plain characters, at the rate of the line, so that XOFF takes effect within a few characters and a stop knows
/// the number of sent characters.</summary>
public sealed class ProgramSender
{
    /// <summary>Maximum number of characters written at once, which may still arrive after an XOFF. Controls for punched tape tolerate 16 or more.</summary>
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
    /// <returns>The result; a stop, a failed port and a pause that is too long are results too.</returns>
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

    /// <summary>Waits while the receiver has paused.</summary>
    /// <exception cref="TimeoutException">It did not resume in time.</exception>
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

    /// <summary>Waits by the schedule of the line: late timers do not slow down the transmission, and longer delays are not compensated by a burst.</summary>
    private async Task WaitAsync(TimeSpan span, CancellationToken stop)
    {
        var now = _time.GetElapsedTime(_begun);
        _due = (_due < now - s_moment ? now : _due) + span;
        if (_due > now) await Task.Delay(_due - now, _time, stop).ConfigureAwait(false);
    }
}

/// <summary>Rate and flow control of a transmission.</summary>
/// <param name="Frame">Frame of received characters.</param>
/// <param name="CharacterTime">Time of one character on the line.</param>
public sealed record SendPace(CharacterFrame Frame, TimeSpan CharacterTime)
{
    /// <summary>Additional delay after every character.</summary>
    public TimeSpan CharacterDelay { get; init; }

    /// <summary>Delay after every line.</summary>
    public TimeSpan LineDelay { get; init; }

    /// <summary>True to obey XOFF and XON.</summary>
    public bool ObeysXoff { get; init; } = true;

    /// <summary>Maximum duration of one pause by the receiver.</summary>
    public TimeSpan LongestHold { get; init; } = TimeSpan.FromSeconds(60);
}

/// <summary>Progress of a transmission.</summary>
public sealed record SendProgress(int Lines, int AllLines, long Characters, int Holds);

/// <summary>Result of a transmission.</summary>
/// <param name="Lines">Lines of the program that were sent completely.</param>
/// <param name="Characters">All sent characters, including leader and line ends.</param>
/// <param name="Holds">Number of received XOFF.</param>
/// <param name="Heard">Received characters other than XON and XOFF.</param>
/// <param name="Reason">Why it failed, a sentence; null if it completed or was stopped.</param>
public sealed record SendResult(SendOutcome Outcome, int Lines, int AllLines, long Characters, int Holds, long Heard, double Seconds, string? Reason);

public enum SendOutcome : byte
{
    Complete,

    /// <summary>Stopped by the operator.</summary>
    Stopped,

    LinkLost,

    /// <summary>The other side sent XOFF and no XON in time.</summary>
    HeldTooLong,
}
