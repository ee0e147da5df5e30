using Engraver.Core.Machines;
using Engraver.Galil.Programs;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Detects a job without progress: it sent no command, and the controller neither moved nor counted. Otherwise the job would wait forever for a
/// motion that does not happen, and keep the watchdog from tripping.</summary>
/// <remarks>Measured in controller time, so that a slow host is not mistaken for a stalled machine; and by several polls, because a single late reply
/// proves nothing.</remarks>
internal sealed class ProgressWatch(MotionProgram program)
{
    private const double SamplesPerSecond = 1000.0;
    private const int FewestPolls = 10;

    private JobPoll? _last;
    private long _since;
    private int _polls;

    /// <summary>Controller seconds without progress until a job is given up.</summary>
    public double Seconds { get; } = StandstillLimit.Seconds(program.Profile, program.LongestWait);

    /// <summary>The controller accepted a command of the job: the time without progress starts again.</summary>
    public void Acted() => _last = null;

    /// <summary>Call with each poll.</summary>
    public bool IsStalled(in JobPoll now)
    {
        if (_last is not { } last || HasProgress(last, now)) (_since, _polls) = (now.Time, 0);
        _last = now;
        return ++_polls > FewestPolls && PollTimes.SamplesSince(_since, now.Time) > Seconds * SamplesPerSecond;
    }

    private static bool HasProgress(in JobPoll before, in JobPoll now) =>
        before.Position != now.Position || before.Counter != now.Counter || before.Calls != now.Calls || before.SequenceRunning != now.SequenceRunning || before.AxesRunning != now.AxesRunning;
}
