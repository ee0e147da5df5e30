using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>The part of the machine session that keeps the controller ready for the next press of a jog pad, so that only the first one waits for the
/// preparation. Whatever else wants the machine ends that first.</summary>
public sealed partial class MachineSession
{
    private ReadyMachine? _ready;

    /// <summary>The machine is kept ready for a jog, and no jog is under way.</summary>
    public bool IsKeptReady => _ready is { Standby.Pressed: null };

    /// <summary>Moves as <see cref="JogAsync"/> does, and stays ready for the next jog.</summary>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up, or what is known of the machine cannot be written down.</exception>
    public async Task<JobResult> JogAndStayReadyAsync(HeldJog held, string journal)
    {
        ArgumentNullException.ThrowIfNull(held);
        if (IsHeld) return await JogAsync(held, journal, CancellationToken.None).ConfigureAwait(false); // the job that stands held is ready by itself
        if (_ready is { } kept && kept.Profile == Profile && TakeUp(kept, held.Control) is { } jog) return await EndedAsync(kept, jog).ConfigureAwait(false);
        var ready = await BeginReadyAsync(held.Control, journal).ConfigureAwait(false);
        return await EndedAsync(ready, ready.First!).ConfigureAwait(false);
    }

    /// <summary>Makes the machine ready for a jog that is expected; does nothing while it moves, or is ready.</summary>
    /// <returns>Completes when the controller has been left again.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected.</exception>
    public async Task GetReadyAsync(string journal)
    {
        if (_ready is not null || IsRunning) return;
        if (_watched.Connection is null) throw new InvalidOperationException("No controller is connected.");
        await (await BeginReadyAsync(null, journal).ConfigureAwait(false)).Left.ConfigureAwait(false);
    }

    /// <summary>Gives the controller back, where it is only kept ready.</summary>
    private Task FreeAsync()
    {
        if (_ready is not { Standby.Pressed: null } ready) return Task.CompletedTask;
        ready.Standby.Leave();
        return ready.Left;
    }

    private async Task<ReadyMachine> BeginReadyAsync(JogControl? control, string journal)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Connection is not { } connection) throw new InvalidOperationException("No controller is connected.");
        if (IsRunning) throw new InvalidOperationException("A job runs already.");
        var standby = new JogStandby { Seen = reading => Seen(reading with { ProgramRuns = false }) }; // the program is ours
        var ready = new ReadyMachine(standby, Profile, control is null ? null : standby.Press(control));
        _ready = ready;
        _ = KeepReadyAsync(connection, ready, journal);
        return ready;
    }

    private async Task KeepReadyAsync(MachineConnection connection, ReadyMachine ready, string journal)
    {
        try
        {
            var result = await _work.RunAsync(stop => StandReadyAsync(connection, ready, journal, stop), CancellationToken.None).ConfigureAwait(false);
            ready.Standby.Over(result);
        }
        catch (Exception failure) when (failure is ControllerException or InvalidOperationException)
        {
            ready.Standby.Over(failure);
        }
        finally
        {
            Interlocked.CompareExchange(ref _ready, null, ready);
            ready.Leave();
        }
    }

    private async Task<JobResult> StandReadyAsync(MachineConnection connection, ReadyMachine ready, string journal, CancellationToken stop)
    {
        if (ready.First is not null) _status.MoveBegins(Wording.Get("MachineSession.Jogging"));
        else _status.JobIsOver();
        await _watched.GiveWayAsync().ConfigureAwait(false);
        try
        {
            var result = await MachineMove.StandBy(ready.Standby, journal, new JobListener(TellMove)).RunAsync(connection, Hold!, ready.Profile, _status.Here, stop).ConfigureAwait(false);
            if (ready.Standby.Pressed is not null || result.Outcome is not (JobOutcome.Complete or JobOutcome.Stopped)) _status.MoveEnds(result); // a stop between two jogs ended nothing that moved
            return result;
        }
        finally
        {
            await _watched.ResumeAsync(connection).ConfigureAwait(false);
        }
    }

    /// <summary>The next press of a machine that is ready.</summary>
    /// <returns>Null when it is not ready any more.</returns>
    private Task<JobResult>? TakeUp(ReadyMachine ready, JogControl control)
    {
        if (Hold?.KeepMoving() is { } failure) throw MachineMemoryException.NotWritten(failure);
        if (ready.Standby.Press(control) is not { } jog) return null;
        _status.MoveBegins(Wording.Get("MachineSession.Jogging"));
        RaiseChanged();
        return jog;
    }

    /// <summary>Waits for the end of a jog; where the machine stays ready its place is kept.</summary>
    private async Task<JobResult> EndedAsync(ReadyMachine ready, Task<JobResult> jog)
    {
        var result = await jog.ConfigureAwait(false);
        if (ready.Standby.IsLeaving && result.Outcome != JobOutcome.Complete) await ready.Left.ConfigureAwait(false);
        if (!ReferenceEquals(_ready, ready) || ready.Standby.Pressed is not null) return result;
        Hold?.KeepEnd(result);
        _status.JobIsOver();
        RaiseChanged();
        return result;
    }
}

/// <summary>A machine that is kept ready for jogs.</summary>
/// <param name="First">The jog for which it was made ready; null when none was asked for yet.</param>
internal sealed record ReadyMachine(JogStandby Standby, MachineProfile Profile, Task<JobResult>? First)
{
    private readonly TaskCompletionSource _left = new(TaskCreationOptions.RunContinuationsAsynchronously);

    /// <summary>Completes when the controller has been left as it was found.</summary>
    public Task Left => _left.Task;

    public void Leave() => _left.TrySetResult();
}
