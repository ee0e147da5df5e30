namespace Engraver.Cli;

/// <summary>Whether the verb has a machine in its hands. While it has, the operator's stop is the verb's business: it brakes the machine and then ends. Otherwise the program just ends.</summary>
/// <remarks>Any thread. A stop is asked for first and this is looked at second, a verb takes first and looks for the stop second: whatever the order, no machine is touched by a program that is leaving.</remarks>
internal sealed class MachineInHand
{
    private int _taken;

    public bool IsTaken => Interlocked.CompareExchange(ref _taken, 0, 0) != 0;

    /// <summary>From now on a stop waits for the verb.</summary>
    /// <exception cref="OperationCanceledException">The stop came before; the machine must not be touched any more.</exception>
    public void Take(CancellationToken stop)
    {
        Follow(true);
        stop.ThrowIfCancellationRequested();
    }

    /// <summary>For a verb that may connect and let go as it likes; what it begins with a machine is ended by the token.</summary>
    public void Follow(bool isConnected) => Interlocked.Exchange(ref _taken, isConnected ? 1 : 0);
}
