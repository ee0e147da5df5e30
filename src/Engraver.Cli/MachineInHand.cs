namespace Engraver.Cli;

/// <summary>Whether the verb has a machine in its hands. While it has, the operator's stop is the verb's business: it brakes the machine and then ends, or lets it go. Otherwise the program just ends.</summary>
/// <remarks>Any thread. The stop is asked for before this is looked at: whoever connects too late to be seen here finds the stop asked for, and begins nothing.</remarks>
internal sealed class MachineInHand
{
    private readonly Lock _guard = new();
    private TaskCompletionSource? _held;

    /// <summary>A machine is connected, or not any more.</summary>
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

    /// <summary>Ends when none is in hand.</summary>
    public Task LetGoAsync()
    {
        lock (_guard) return _held?.Task ?? Task.CompletedTask;
    }
}
