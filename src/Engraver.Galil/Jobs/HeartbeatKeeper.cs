using System.Runtime.ExceptionServices;
using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs;

/// <summary>Sends heartbeats beside the job: where a busy computer delays the job between two commands, the link is free and the watchdog must not
/// trip.</summary>
/// <remarks>It ends with the process, and it stops when the job itself has not acted for some seconds (<see cref="Programs.Resident.Heartbeat"/>).</remarks>
internal sealed class HeartbeatKeeper : IAsyncDisposable
{
    private static readonly TimeSpan s_period = TimeSpan.FromMilliseconds(100);

    private readonly CancellationTokenSource _end = new();
    private readonly Task _keeping;
    private volatile ExceptionDispatchInfo? _failure;

    /// <param name="isDue">Called ten times a second.</param>
    /// <param name="beat">Sends a heartbeat.</param>
    public HeartbeatKeeper(TimeProvider time, Func<bool> isDue, Func<ValueTask> beat) => _keeping = KeepAsync(time, isDue, beat);

    /// <exception cref="ControllerException">A heartbeat failed: the job ends as by a command of its own.</exception>
    public void ThrowIfFailed() => _failure?.Throw();

    public async ValueTask DisposeAsync()
    {
        await _end.CancelAsync().ConfigureAwait(false);
        await _keeping.ConfigureAwait(false);
        _end.Dispose();
    }

    private async Task KeepAsync(TimeProvider time, Func<bool> isDue, Func<ValueTask> beat)
    {
        using var timer = new PeriodicTimer(s_period, time);
        try
        {
            while (await timer.WaitForNextTickAsync(_end.Token).ConfigureAwait(false))
            {
                if (isDue()) await beat().ConfigureAwait(false);
            }
        }
        catch (OperationCanceledException)
        {
            // The job has ended, or the operator has stopped it: nothing more is sent.
        }
        catch (ControllerException failed)
        {
            _failure = ExceptionDispatchInfo.Capture(failed);
        }
    }
}
