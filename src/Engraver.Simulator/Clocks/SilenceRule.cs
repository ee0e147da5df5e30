namespace Engraver.Simulator.Clocks;

/// <summary>Virtual time while no host has the clock (<see cref="HostClock"/>): after 5 ms of wall time without a byte, time advances to the next event; while
/// an open sequence
/// waits for its host, it advances only after 2 s (contract of "engraver simulate", speed max).</summary>
internal sealed class SilenceRule(Machine machine, TimeProvider time)
{
    /// <summary>Wall time without a byte from any host after which time passes; also the period of the check.</summary>
    public static readonly TimeSpan Short = TimeSpan.FromMilliseconds(5);

    /// <summary>The same while a started sequence without VE waits for its host.</summary>
    private static readonly TimeSpan Long = TimeSpan.FromSeconds(2);

    /// <summary>Maximum number of samples in one call of <see cref="Poll"/>: of motion without an event, and (<see cref="BusyLeap"/>) of threads that never
    /// wait.</summary>
    private const long LongestLeap = 20_000;
    private const long BusyLeap = 5;

    private long _lastSign = time.GetTimestamp();

    /// <summary>Wall time since a host connected, disconnected or sent something.</summary>
    public TimeSpan Silent => time.GetElapsedTime(_lastSign);

    /// <summary>Called when a host has connected, disconnected or sent something.</summary>
    public void ByteReceived() => _lastSign = time.GetTimestamp();

    public void Poll()
    {
        if (machine.IsDormant || Silent < (machine.AwaitsSegments ? Long : Short)) return;
        machine.AdvanceToEvent(Leap());
    }

    /// <summary>Maximum number of samples to advance: unlimited while everything waits; few when samples or program lines must be computed, so that one call
    /// stays short.</summary>
    private long Leap() =>
        machine.Motion.CanProgress ? LongestLeap
        : machine.Threads.QuietUntil(machine.Sample) <= machine.Sample ? BusyLeap
        : int.MaxValue;
}
