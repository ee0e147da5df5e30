namespace Engraver.Cli;

/// <summary>Knows whether the verb has a machine connected. While it has, the verb itself answers the operator's stop: it brakes the machine and then ends,
/// or disconnects. Otherwise the program just ends.</summary>
/// <remarks>Any thread. The stop is requested before this is asked: a verb that connects too late to be seen here finds the stop requested, and begins
/// nothing.</remarks>
internal sealed class MachineInHand
{
    private readonly Lock _guard = new();
    private TaskCompletionSource? _held;

    /// <summary>Called when a machine is connected (true) or no longer connected (false).</summary>
    public void Follow(bool isConnected)
    {
        lock (_guard)
        {
            if (isConnected)
            {
                _held ??= new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
                return;
            }

            _held?.SetResult();
            _held = null;
        }
    }

    /// <summary>Completes when no machine is connected.</summary>
    public Task LetGoAsync()
    {
        lock (_guard) return _held?.Task ?? Task.CompletedTask;
    }
}
