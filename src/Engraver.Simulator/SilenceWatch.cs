using Engraver.Simulator.Protocol;

namespace Engraver.Simulator;

/// <summary>Virtual time while the hosts are silent: it goes from event to event, but waits longer for the host of an open sequence (contract of "engraver simulate") and for one that is in the middle of a job.</summary>
/// <remarks>A job asks without a pause where the clock runs ahead, so many questions in a row are its sign, together with a running program that counts down what the host winds up; whoever only sends
/// commands and waits for the end of a motion or a program finds the clock jumping as ever. A host whose connection is gone is not waited for, and one that is there but says nothing is given up after the patience, once: from then on time goes on without it, and a watchdog finds it dead.</remarks>
internal sealed class SilenceWatch(Machine machine, TimeProvider time)
{
    /// <summary>Wall time without a byte from any host after which the clock goes on; also the period of looking.</summary>
    public static readonly TimeSpan Short = TimeSpan.FromMilliseconds(5);

    /// <summary>The same when a begun sequence without VE waits for its host, and when a host that leads a job has fallen silent.</summary>
    private static readonly TimeSpan Long = TimeSpan.FromSeconds(2);

    /// <summary>The same when the host that spoke last has not taken its answer yet: its computer is busy with something else.</summary>
    private static readonly TimeSpan Unanswered = TimeSpan.FromMilliseconds(500);

    /// <summary>A host that asked so much more often than it paused is leading a job: it will ask again, and its computer was only held up.</summary>
    private const long Leading = 12;

    /// <summary>A pause takes so many questions back: whoever looks now and then, a display or a terminal, leads nothing.</summary>
    private const long PauseCounts = 4;

    /// <summary>What was asked long ago does not count.</summary>
    private const long MostLead = 32;

    /// <summary>Samples that one look may carry a motion without an event, and threads that never wait.</summary>
    private const long LongestLeap = 20_000;
    private const long BusyLeap = 5;

    private long _lastSign = time.GetTimestamp();
    private Handle? _speaker;
    private long _lead;

    /// <summary>A host gave a sign of life.</summary>
    /// <param name="speaker">The one that said something; null for one that came or went.</param>
    /// <param name="asked">Questions that it asked with it.</param>
    public void Heard(Handle? speaker, long asked = 0)
    {
        var paused = time.GetElapsedTime(_lastSign) >= Short ? PauseCounts : 0;
        _lead = speaker is null ? 0 : Math.Clamp(_lead + asked - paused, 0, MostLead);
        (_lastSign, _speaker) = (time.GetTimestamp(), speaker);
    }

    public void Look()
    {
        var silent = time.GetElapsedTime(_lastSign);
        if (silent < Short || machine.IsDormant || silent < Patience()) return;
        if (IsLed) _lead = 0; // waited for once
        machine.AdvanceToEvent(Leap());
    }

    private TimeSpan Patience() => machine.AwaitsSegments || IsLed ? Long : _speaker is { IsInConversation: true } ? Unanswered : Short;

    private bool IsLed => _lead >= Leading && _speaker is { IsClosed: false } && machine.Threads.Running != 0 && machine.Variables.IsShared;

    /// <summary>Pure waiting is jumped over whatever its length; simulated samples and lines take processor time and come in portions.</summary>
    private long Leap() =>
        machine.Motion.CanProgress ? LongestLeap
        : machine.Threads.QuietUntil(machine.Sample) <= machine.Sample ? BusyLeap
        : int.MaxValue;
}
