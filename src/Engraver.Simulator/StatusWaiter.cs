namespace Engraver.Simulator;

/// <summary>Someone who awaits a status of the controller.</summary>
internal sealed class StatusWaiter(Func<ControllerStatus, bool> condition)
{
    private readonly TaskCompletionSource<ControllerStatus> completion = new(TaskCreationOptions.RunContinuationsAsynchronously);

    public Task<ControllerStatus> Task => completion.Task;

    public void Offer(ControllerStatus status)
    {
        if (condition(status))
        {
            completion.TrySetResult(status);
        }
    }
}
