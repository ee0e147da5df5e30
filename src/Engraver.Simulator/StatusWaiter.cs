namespace Engraver.Simulator;

/// <summary>Someone who awaits a status of the controller.</summary>
internal sealed class StatusWaiter(Func<ControllerStatus, bool> condition)
{
    private readonly TaskCompletionSource<ControllerStatus> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);

    public Task<ControllerStatus> Task => _completion.Task;

    public void Offer(ControllerStatus status)
    {
        if (condition(status)) _completion.TrySetResult(status);
    }
}
