namespace Engraver.Simulator;

/// <summary>Virtual time while the hosts are silent: it goes from event to event, but waits longer for the host of an open sequence (contract of "engraver simulate").</summary>
internal sealed class SilenceWatch(Machine machine, TimeProvider time)
{
    /// <summary>Wall time without a byte from any host after which the clock goes on; also the period of looking.</summary>
    public static readonly TimeSpan Short = TimeSpan.FromMilliseconds(5);

    /// <summary>The same when a begun sequence without VE waits for its host.</summary>
    private static readonly TimeSpan Long = TimeSpan.FromSeconds(2);

    /// <summary>Samples that one look may carry a motion without an event, and threads that never wait.</summary>
    private const long LongestLeap = 20_000;
    private const long BusyLeap = 5;

    private long _lastSign = time.GetTimestamp();

    /// <summary>A host gave a sign of life.</summary>
    public void Heard() => _lastSign = time.GetTimestamp();

    public void Look()
    {
        var silent = time.GetElapsedTime(_lastSign);
        if (silent >= Short && !machine.IsDormant && (silent >= Long || !machine.AwaitsSegments))
            machine.AdvanceToEvent(Leap());
    }

    /// <summary>Pure waiting is jumped over whatever its length; simulated samples and lines take processor time and come in portions.</summary>
    private long Leap() =>
        machine.Motion.CanProgress ? LongestLeap
        : machine.Threads.QuietUntil(machine.Sample) <= machine.Sample ? BusyLeap
        : int.MaxValue;
}
