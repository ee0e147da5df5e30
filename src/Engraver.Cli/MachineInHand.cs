namespace Engraver.Cli;

/// <summary>Whether the verb has a machine in its hands. While it has, the operator's stop is the verb's business: it brakes the machine and then ends. Otherwise the program just ends.</summary>
/// <remarks>Any thread. The stop is asked for before this is looked at: whoever connects too late to be seen here finds the stop asked for, and begins nothing.</remarks>
internal sealed class MachineInHand
{
    private int _taken;

    public bool IsTaken => Interlocked.CompareExchange(ref _taken, 0, 0) != 0;

    /// <summary>A machine is connected, or not any more.</summary>
    public void Follow(bool isConnected) => Interlocked.Exchange(ref _taken, isConnected ? 1 : 0);
}
