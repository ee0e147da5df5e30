namespace Engraver.Simulator.Clocks;

/// <summary>Virtual time while no host has taken the clock (<see cref="HostClock"/>): after 5 ms of the wall without a byte it goes on to the next event, but not while an open sequence
/// waits for its host, until 2 s of silence (contract of "engraver simulate", speed max).</summary>
internal sealed class SilenceRule(Machine machine, TimeProvider time)
{
    /// <summary>Wall time without a byte from any host after which the clock goes on; also the period of looking.</summary>
    public static readonly TimeSpan Short = TimeSpan.FromMilliseconds(5);

    /// <summary>The same while a begun sequence without VE waits for its host.</summary>
    private static readonly TimeSpan Long = TimeSpan.FromSeconds(2);

    /// <summary>Samples that one look may carry a motion without an event, and threads that never wait.</summary>
    private const long LongestLeap = 20_000;
    private const long BusyLeap = 5;

    private long _lastSign = time.GetTimestamp();

    /// <summary>Wall time since a host came, went or said something.</summary>
    public TimeSpan Silent => time.GetElapsedTime(_lastSign);

    /// <summary>A host gave a sign of life.</summary>
    public void Heard() => _lastSign = time.GetTimestamp();

    public void Look()
    {
        if (machine.IsDormant || Silent < (machine.AwaitsSegments ? Long : Short)) return;
        machine.AdvanceToEvent(Leap());
    }

    /// <summary>Pure waiting is jumped over whatever its length; simulated samples and lines take processor time and come in portions.</summary>
    private long Leap() =>
        machine.Motion.CanProgress ? LongestLeap
        : machine.Threads.QuietUntil(machine.Sample) <= machine.Sample ? BusyLeap
        : int.MaxValue;
}
