using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;

namespace Engraver.Workbench.Machines;

/// <summary>A controller that is kept ready for jogs.</summary>
/// <param name="Profile">The profile for which it was prepared.</param>
/// <param name="First">The jog for which it was made ready; null when none was requested yet.</param>
internal sealed record StandbyMachine(JogStandby Standby, MachineProfile Profile, Task<JobResult>? First)
{
    private readonly TaskCompletionSource _closed = new(TaskCreationOptions.RunContinuationsAsynchronously);

    /// <summary>Completes when the controller has been left as it was found.</summary>
    public Task Closed => _closed.Task;

    public void Close() => _closed.TrySetResult();
}
