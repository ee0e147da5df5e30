using Engraver.Core.Languages;
using Engraver.Core.Sending;

namespace Engraver.Workbench.Sending;

/// <summary>Sends a program over a serial line as plain characters, at the rate of the line, so that XOFF takes effect within a few characters and a stop knows
/// the number of sent characters.</summary>
public sealed class ProgramSender
{
    /// <summary>Maximum number of characters written at once, which may still arrive after an XOFF. Controls for punched tape tolerate 16 or more.</summary>
    private const int Chunk = 8;

    private static readonly TimeSpan s_maxCatchUp = TimeSpan.FromMilliseconds(5);

    private readonly IProgramPort _line;
    private readonly SendPace _pace;
    private readonly TimeProvider _time;
    private readonly FlowControl _gate;
    private TimeSpan _due;
    private long _startTime;
    private long _characters;
    private int _lines;

    private ProgramSender(IProgramPort line, SendPace pace, TimeProvider time)
    {
        (_line, _pace, _time) = (line, pace, time);
        _gate = new FlowControl(line, pace.Frame, pace.ObeysXoff);
    }

    /// <summary>Sends everything.</summary>
    /// <returns>The result; a stop, a failed port and a pause that is too long are results too.</returns>
    public static Task<SendResult> SendAsync(IProgramPort line, SendJob job, SendPace pace, IProgress<SendProgress>? progress, TimeProvider time, CancellationToken stop)
    {
        ArgumentNullException.ThrowIfNull(line);
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(pace);
        ArgumentNullException.ThrowIfNull(time);
        return new ProgramSender(line, pace, time).RunAsync(job, progress, stop);
    }

    private async Task<SendResult> RunAsync(SendJob job, IProgress<SendProgress>? progress, CancellationToken stop)
    {
        _startTime = _time.GetTimestamp();
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
            return Result(SendOutcome.PausedTooLong, job, held.Message);
        }
        catch (IOException gone)
        {
            return Result(SendOutcome.LinkLost, job, SystemErrorText.FromException(gone));
        }
        finally
        {
            await listening.CancelAsync().ConfigureAwait(false);
            await ears.ConfigureAwait(false);
        }
    }

    private SendResult Result(SendOutcome outcome, SendJob job, string? reason) =>
        new(outcome, _lines, job.Lines.Count, _characters, _gate.Pauses, _gate.OtherBytes, _time.GetElapsedTime(_startTime).TotalSeconds, reason);

    private async Task SendAllAsync(SendJob job, IProgress<SendProgress>? progress, CancellationToken stop)
    {
        await SendAsync(job.Leader, stop).ConfigureAwait(false);
        foreach (var line in job.Lines)
        {
            await SendAsync(line, stop).ConfigureAwait(false);
            _lines++;
            progress?.Report(new SendProgress(_lines, job.Lines.Count, _characters, _gate.Pauses));
            await WaitAsync(_pace.LineDelay, stop).ConfigureAwait(false);
        }

        await SendAsync(job.Trailer, stop).ConfigureAwait(false);
        await OpenAsync(stop).ConfigureAwait(false);
    }

    private async Task SendAsync(ReadOnlyMemory<byte> bytes, CancellationToken stop)
    {
        var most = _pace.CharacterDelay > TimeSpan.Zero ? 1 : Chunk;
        while (!bytes.IsEmpty)
        {
            await OpenAsync(stop).ConfigureAwait(false);
            var now = bytes[..Math.Min(most, bytes.Length)];
            await _line.WriteAsync(now, stop).ConfigureAwait(false);
            await WaitAsync((_pace.CharacterTime + _pace.CharacterDelay) * now.Length, stop).ConfigureAwait(false);
            _characters += now.Length;
            bytes = bytes[now.Length..];
        }
    }

    /// <summary>Waits while the receiver has paused.</summary>
    /// <exception cref="TimeoutException">It did not resume in time.</exception>
    private async Task OpenAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var open = _gate.WaitUntilOpenAsync();
        if (open.IsCompleted) return;
        try
        {
            await open.WaitAsync(_pace.MaxPause, _time, stop).ConfigureAwait(false);
        }
        catch (TimeoutException never)
        {
            throw new TimeoutException(Wording.Get("ProgramSender.XoffTimeout", _pace.MaxPause.TotalSeconds), never);
        }
    }

    /// <summary>Waits by the schedule of the line: late timers do not slow down the transmission, and longer delays are not compensated by a burst.</summary>
    private async Task WaitAsync(TimeSpan span, CancellationToken stop)
    {
        var now = _time.GetElapsedTime(_startTime);
        _due = (_due < now - s_maxCatchUp ? now : _due) + span;
        if (_due > now) await Task.Delay(_due - now, _time, stop).ConfigureAwait(false);
    }
}
