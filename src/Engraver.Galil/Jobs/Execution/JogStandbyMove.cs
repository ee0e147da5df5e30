using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Keeps the controller ready for jogs: the job's program is in its memory and its watchdog runs, so that a press sends no more than the motion.
/// Between two jogs the machine is polled, with the heartbeat of a job.</summary>
internal sealed class JogStandbyMove(JobMachine machine, JogStandby standby, IReadOnlyList<SoftLimit> limits) : IJobStrategy
{
    /// <summary>Without a press the controller gets its own program back after this time.</summary>
    private static readonly TimeSpan s_longest = TimeSpan.FromSeconds(60);

    /// <summary>Between two readings for the status, which on a serial line must not delay a press.</summary>
    private static readonly TimeSpan s_pollInterval = TimeSpan.FromMilliseconds(100);

    private static readonly TimeSpan s_slowPollInterval = TimeSpan.FromSeconds(1);

    private const int RestsBetweenPolls = 5;

    private long _lastPoll;

    public Phase Whole => Phase.Idle;

    public ValueTask StartAsync() => ValueTask.CompletedTask;

    public async ValueTask CutAsync()
    {
        var idleSince = _lastPoll = machine.Time.GetTimestamp();
        while (true)
        {
            if (standby.Pressed is { } control)
            {
                await JogAsync(control).ConfigureAwait(false);
                idleSince = machine.Time.GetTimestamp();
            }
            else if (standby.IsLeaving)
            {
                return;
            }
            else if (machine.Time.GetElapsedTime(idleSince) > s_longest)
            {
                standby.Leave();
            }
            else
            {
                await StandByAsync().ConfigureAwait(false);
            }
        }
    }

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;

    private async ValueTask StandByAsync()
    {
        machine.Watch.HasProgress(); // it is at rest on purpose
        await machine.PollAsync().ConfigureAwait(false);
        if (standby.Pressed is null && machine.Time.GetElapsedTime(_lastPoll) >= (machine.Line is null ? s_pollInterval : s_slowPollInterval))
        {
            standby.Seen?.Invoke(await machine.ReadStatusAsync().ConfigureAwait(false));
            _lastPoll = machine.Time.GetTimestamp();
        }

        for (var i = 0; i < RestsBetweenPolls && standby is { Pressed: null, IsLeaving: false }; i++) await machine.RestAsync(double.PositiveInfinity).ConfigureAwait(false);
    }

    private async ValueTask JogAsync(JogControl control)
    {
        machine.Watch.HasProgress();
        await new JogMove(machine, control, limits).KeptReadyAsync().ConfigureAwait(false);
        await machine.Commands.WatchAsUsualAsync().ConfigureAwait(false);
        standby.CompleteJog(JobResult.NotStarted(0, Wording.Get("JogMove.AtRest")) with { Outcome = JobOutcome.Complete, FinalPosition = machine.State.Position, FrameOrigin = machine.Frame.Taken });
    }
}
