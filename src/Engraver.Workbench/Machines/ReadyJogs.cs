using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>Jogs of a jog pad, between which the controller is kept ready, so that only the first press waits for its preparation. Everything else that
/// needs the machine ends that first (<see cref="MotionInterlock"/>).</summary>
public sealed class ReadyJogs
{
    private readonly ConnectedMachine _machine;
    private readonly MotionInterlock _interlock;
    private readonly HandMoves _hand;
    private readonly OperatorControls _controls;
    private readonly MachineStatusModel _status;

    internal ReadyJogs(ConnectedMachine machine, MotionInterlock interlock, HandMoves hand, OperatorControls controls, MachineStatusModel status) =>
        (_machine, _interlock, _hand, _controls, _status) = (machine, interlock, hand, controls, status);

    /// <summary>The controller is kept ready for a jog, and no jog is under way.</summary>
    public bool IsKeptReady => _interlock.IsKeptReady;

    /// <summary>Moves as <see cref="HandMoves.JogAsync"/> does, and stays ready for the next jog.</summary>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up, or what is known of the machine cannot be stored.</exception>
    public async Task<JobResult> JogAsync(ContinuousJog held, string journal)
    {
        ArgumentNullException.ThrowIfNull(held);
        if (_controls.IsHeld) return await _hand.JogAsync(held, journal, CancellationToken.None).ConfigureAwait(false); // a job that is held needs no preparation
        if (_interlock.Ready is { } kept && kept.Profile == _status.Profile && StartJog(kept, held.Control) is { } jog) return await EndedAsync(kept, jog).ConfigureAwait(false);
        var ready = await BeginAsync(held.Control, journal).ConfigureAwait(false);
        return await EndedAsync(ready, ready.First!).ConfigureAwait(false);
    }

    /// <summary>Makes the machine ready for a jog that is expected; does nothing while it moves, or is ready.</summary>
    /// <returns>Completes when the controller has been left again.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected.</exception>
    public async Task PrepareAsync(string journal)
    {
        if (_interlock.Ready is not null || _interlock.IsRunning) return;
        await (await BeginAsync(null, journal).ConfigureAwait(false)).Closed.ConfigureAwait(false);
    }

    private async Task<StandbyMachine> BeginAsync(JogControl? control, string journal)
    {
        var connection = await _machine.FreeAsync().ConfigureAwait(false);
        if (_interlock.IsRunning) throw new InvalidOperationException("A job runs already.");
        var standby = new JogStandby { Seen = reading => _machine.Poll(reading with { IsProgramRunning = false }) }; // the program of this standby
        var ready = new StandbyMachine(standby, _status.Profile, control is null ? null : standby.Press(control));
        _interlock.KeepReady(ready);
        _ = KeepAsync(connection, ready, journal);
        return ready;
    }

    private async Task KeepAsync(MachineConnection connection, StandbyMachine ready, string journal)
    {
        try
        {
            ready.Standby.Complete(await _machine.UseAsync(connection, () => Begin(ready), (one, stop) => StandByAsync(one, ready, journal, stop), CancellationToken.None).ConfigureAwait(false));
        }
        catch (Exception failure) when (failure is ControllerException or InvalidOperationException)
        {
            ready.Standby.Complete(failure);
        }
        finally
        {
            _interlock.EndReady(ready);
        }
    }

    private void Begin(StandbyMachine ready)
    {
        if (ready.First is not null) _status.MoveStarted(Wording.Get("MachineSession.Jogging"));
    }

    private async Task<JobResult> StandByAsync(MachineConnection connection, StandbyMachine ready, string journal, CancellationToken stop)
    {
        var move = MachineMove.JogStandby(ready.Standby, journal, new JobListener(_status.MoveProgressed));
        var result = await move.RunAsync(connection, _machine.Lease!, ready.Profile, _status.Position, stop).ConfigureAwait(false);
        if (ready.Standby.Pressed is not null || result.Outcome is not (JobOutcome.Complete or JobOutcome.Stopped)) _status.MoveEnded(result); // a stop between two jogs ended no motion
        return result;
    }

    /// <summary>The next press on a machine that is ready.</summary>
    /// <returns>Null when it is no longer ready.</returns>
    private Task<JobResult>? StartJog(StandbyMachine ready, JogControl control)
    {
        if (_machine.Lease?.NoteMoving() is { } failure) throw MachineMemoryException.NotWritten(failure);
        if (ready.Standby.Press(control) is not { } jog) return null;
        _status.MoveStarted(Wording.Get("MachineSession.Jogging"));
        _status.RaiseChanged();
        return jog;
    }

    /// <summary>Waits for the end of a jog; where the machine stays ready its position is stored.</summary>
    private async Task<JobResult> EndedAsync(StandbyMachine ready, Task<JobResult> jog)
    {
        var result = await jog.ConfigureAwait(false);
        if (ready.Standby.IsLeaving && result.Outcome != JobOutcome.Complete) await ready.Closed.ConfigureAwait(false);
        if (!ReferenceEquals(_interlock.Ready, ready) || ready.Standby.Pressed is not null) return result;
        _machine.Lease?.NoteMotionEnd(result);
        _status.ClearJog();
        _status.RaiseChanged();
        return result;
    }
}
