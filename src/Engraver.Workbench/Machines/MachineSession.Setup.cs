using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Setup;

namespace Engraver.Workbench.Machines;

/// <summary>The part of the machine session by which a machine is commissioned: what the controller knows of its wiring, and test moves by other counts and
/// speeds than the profile's.</summary>
public sealed partial class MachineSession
{
    /// <summary>Whether the connected controller can be told of its wiring now.</summary>
    public bool CanBeSetUp => (_watched.Watch?.Setup is not null || IsKeptReady) && !IsRunning;

    /// <summary>Reads or sets what the controller knows of its wiring, and looks at the machine afterwards. Disarms.</summary>
    /// <exception cref="InvalidOperationException">Not now (<see cref="CanBeSetUp"/>).</exception>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<T> SetUpAsync<T>(Func<IMachineSetup, Task<T>> act, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(act);
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Watch is not { Setup: { } setup } watch || IsRunning) throw new InvalidOperationException("Nothing is connected that can be set up, or a job runs.");
        Disarm();
        var done = await act(setup).ConfigureAwait(false);
        Seen(await watch.LookAsync(cancellation).ConfigureAwait(false));
        return done;
    }

    /// <summary>Goes to a place as <see cref="GoToAsync"/> does, by a profile of its own.</summary>
    /// <param name="test">The axes of the machine's profile in the same order, and the speed.</param>
    public Task<JobResult> TestMoveAsync(CountsPoint goal, MachineProfile test, string journal, CancellationToken cancellation) => MoveByHandAsync(test, MachineMove.Test(goal, Profile, journal, new JobListener(TellMove)), cancellation);

    /// <summary>Draws a path from where the machine stands, tool off. It is stopped as a job is.</summary>
    /// <param name="path">Begins at 0,0, where the machine stands; its profile has the axes of the machine's in the same order.</param>
    public Task<JobResult> TestPathAsync(MotionProgram path, string journal, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(path);
        return MoveByHandAsync(path.Profile, MachineMove.Path(path, Profile, journal, new JobListener(TellMove)), cancellation);
    }

    /// <summary>Switches the tool output of a profile on for its settle time, at standstill.</summary>
    public Task<JobResult> TestOutputAsync(MachineProfile test, string journal, CancellationToken cancellation) => MoveByHandAsync(test, MachineMove.Pulse(Profile, journal), cancellation);

    private async Task<JobResult> MoveByHandAsync(MachineProfile profile, MachineMove move, CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Connection is not { } connection) throw new InvalidOperationException("No controller is connected.");
        return await _work.RunAsync(stop => MoveWatchedAsync(connection, profile, move, stop), cancellation).ConfigureAwait(false);
    }
}
