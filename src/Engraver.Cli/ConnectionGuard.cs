namespace Engraver.Cli;

/// <summary>Whether the running verb has a machine connected. If it has, the program waits on the operator's stop until the verb has stopped the machine and
/// ended or disconnected. Otherwise the program ends at once.</summary>
/// <remarks>Any thread. The stop is requested before this class is read: a verb that connects later sees the requested stop and does not start
/// anything.</remarks>
internal sealed class ConnectionGuard
{
    private readonly Lock _guard = new();
    private TaskCompletionSource? _connected;

    /// <summary>Called when a machine is connected (true) or no longer connected (false).</summary>
    public void SetConnected(bool isConnected)
    {
        lock (_guard)
        {
            if (isConnected)
            {
                _connected ??= new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
                return;
            }

            _connected?.SetResult();
            _connected = null;
        }
    }

    /// <summary>Completes when no machine is connected.</summary>
    public Task WaitForDisconnectAsync()
    {
        lock (_guard) return _connected?.Task ?? Task.CompletedTask;
    }
}
