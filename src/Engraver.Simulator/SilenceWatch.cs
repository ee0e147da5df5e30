using Engraver.Simulator.Protocol;

namespace Engraver.Simulator;

/// <summary>Virtual time while the hosts are silent: it goes from event to event, but waits longer for the host of an open sequence (contract of "engraver simulate").</summary>
internal sealed class SilenceWatch(Machine machine, TimeProvider time)
{
    /// <summary>Wall time without a byte from any host after which the clock goes on; also the period of looking.</summary>
    public static readonly TimeSpan Short = TimeSpan.FromMilliseconds(5);

    /// <summary>The same when a begun sequence without VE waits for its host.</summary>
    private static readonly TimeSpan Long = TimeSpan.FromSeconds(2);

    /// <summary>The same when the host that spoke last has not taken its answer yet: its computer is busy with something else.</summary>
    private static readonly TimeSpan Unanswered = TimeSpan.FromMilliseconds(500);

    /// <summary>Samples that one look may carry a motion without an event, and threads that never wait.</summary>
    private const long LongestLeap = 20_000;
    private const long BusyLeap = 5;

    private long _lastSign = time.GetTimestamp();
    private Handle? _speaker;

    /// <summary>A host gave a sign of life.</summary>
    /// <param name="speaker">The one that said something; null for one that came or went.</param>
    public void Heard(Handle? speaker) => (_lastSign, _speaker) = (time.GetTimestamp(), speaker);

    public void Look()
    {
        var silent = time.GetElapsedTime(_lastSign);
        if (silent >= Short && !machine.IsDormant && silent >= Patience()) machine.AdvanceToEvent(Leap());
    }

    private TimeSpan Patience() => machine.AwaitsSegments ? Long : _speaker is { IsInConversation: true } ? Unanswered : Short;

    /// <summary>Pure waiting is jumped over whatever its length; simulated samples and lines take processor time and come in portions.</summary>
    private long Leap() =>
        machine.Motion.CanProgress ? LongestLeap
        : machine.Threads.QuietUntil(machine.Sample) <= machine.Sample ? BusyLeap
        : int.MaxValue;
}
