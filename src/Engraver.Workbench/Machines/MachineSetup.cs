using Engraver.Core.Machines;
using Engraver.Core.Machines.Setup;

namespace Engraver.Workbench.Machines;

/// <summary>Commissioning of the connected machine: the wiring settings of its controller, and test moves with other counts and speeds than the
/// profile's.</summary>
public sealed class MachineSetup
{
    private readonly ConnectedMachine _machine;
    private readonly MotionInterlock _interlock;
    private readonly MachineStatusModel _status;

    internal MachineSetup(ConnectedMachine machine, MotionInterlock interlock, MachineStatusModel status) => (_machine, _interlock, _status) = (machine, interlock, status);

    /// <summary>Whether the wiring settings of the connected controller can be changed now.</summary>
    public bool IsPossible => (_machine.Watched.Watch?.Setup is not null || _interlock.IsKeptReady) && !_interlock.IsRunning;

    /// <summary>Reads or sets wiring settings of the controller, and polls the machine afterwards. Disarms.</summary>
    /// <exception cref="InvalidOperationException">Not now (<see cref="IsPossible"/>).</exception>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<T> ApplyAsync<T>(Func<IMachineSetup, Task<T>> change, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(change);
        if (await _machine.FindIdleAsync().ConfigureAwait(false) is not { Setup: { } setup } watch) throw new InvalidOperationException("Nothing is connected that can be set up, or a job runs.");
        _status.Arming.Disarm();
        var result = await change(setup).ConfigureAwait(false);
        await _machine.PollAsync(watch, cancellation).ConfigureAwait(false);
        return result;
    }

    /// <summary>Moves to a position as <see cref="HandMoves.GoToAsync"/> does, with a profile of its own.</summary>
    /// <param name="goal">The controller's own counts.</param>
    /// <param name="test">The axes of the machine's profile in the same order, and the speed.</param>
    /// <param name="journal">Path of the journal to which the state found in the controller is written.</param>
    public Task<JobResult> TestMoveAsync(CountsPoint goal, MachineProfile test, string journal, CancellationToken cancellation) => _machine.MoveAsync(test, MachineMove.Test(goal, _status.Profile, journal, new JobListener(_status.MoveProgressed)), cancellation);

    /// <summary>Follows a path from the machine's position, tool off. It is stopped as a job is.</summary>
    /// <param name="path">Begins at 0,0, the machine's position; its profile has the axes of the machine's in the same order.</param>
    /// <param name="journal">Path of the journal to which the state found in the controller is written.</param>
    public Task<JobResult> TestPathAsync(MotionProgram path, string journal, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(path);
        return _machine.MoveAsync(path.Profile, MachineMove.Path(path, _status.Profile, journal, new JobListener(_status.MoveProgressed)), cancellation);
    }

    /// <summary>Switches the tool output of a profile on for its settle time, at standstill.</summary>
    public Task<JobResult> TestOutputAsync(MachineProfile test, string journal, CancellationToken cancellation) => _machine.MoveAsync(test, MachineMove.Pulse(_status.Profile, journal), cancellation);
}
