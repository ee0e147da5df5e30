namespace Engraver.Simulator;

/// <summary>The controller's status, and the tasks that wait for a condition on it. All members are called under the controller's lock.</summary>
internal sealed class StatusModel(Machine machine)
{
    private readonly List<StatusWaiter> _waiters = [];

    public bool IsAwaited => _waiters.Count > 0;

    public void Add(StatusWaiter waiter) => _waiters.Add(waiter);

    public void Remove(StatusWaiter waiter) => _waiters.Remove(waiter);

    /// <summary>Called when the status can have changed: completes the tasks whose condition holds.</summary>
    public void Notify()
    {
        if (_waiters.Count == 0) return;
        var status = Now();
        _waiters.ForEach(waiter => waiter.Offer(status));
    }

    public ControllerStatus Now()
    {
        var planes = machine.Motion.Planes;
        return new ControllerStatus(
            machine.Sample,
            machine.Motion.CanProgress,
            planes[0].IsActive || planes[1].IsActive,
            planes[0].IsDry || planes[1].IsDry,
            machine.Threads.Running,
            machine.Io.Outputs,
            planes[0].Underruns + planes[1].Underruns,
            machine.Handles.Capacity - machine.Handles.Free,
            machine.Motion.SegmentsExecuted);
    }
}

/// <summary>One task that waits for a condition on the status.</summary>
internal sealed class StatusWaiter(Func<ControllerStatus, bool> condition)
{
    private readonly TaskCompletionSource<ControllerStatus> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);

    public Task<ControllerStatus> Task => _completion.Task;

    public void Offer(ControllerStatus status)
    {
        if (condition(status)) _completion.TrySetResult(status);
    }
}
