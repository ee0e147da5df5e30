using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Keeps the controller ready for jogs: our program is in its memory and its watchdog runs, so that a press sends no more than the motion. Between
/// two jogs the machine is polled, with the heartbeat of a job.</summary>
internal sealed class JogStandbyMove(JobMachine machine, JogStandby standby, IReadOnlyList<SoftLimit> limits) : IJobStrategy
{
    /// <summary>Without a press the controller gets its own program back after this time.</summary>
    private static readonly TimeSpan s_longest = TimeSpan.FromSeconds(60);

    /// <summary>Between two looks for the status, which on a serial line must not delay a press.</summary>
    private static readonly TimeSpan s_betweenLooks = TimeSpan.FromMilliseconds(100);

    private static readonly TimeSpan s_betweenSlowLooks = TimeSpan.FromSeconds(1);

    private const int RestsBetweenPolls = 5;

    private long _looked;

    public ValueTask<JobStep> StartAsync() => new(JobStep.Done);

    public async ValueTask<JobStep> CutAsync()
    {
        var stood = _looked = machine.Time.GetTimestamp();
        while (true)
        {
            if (standby.Pressed is { } control)
            {
                if (await JogAsync(control).ConfigureAwait(false) is { Ends: true } end) return end;
                stood = machine.Time.GetTimestamp();
            }
            else if (standby.IsLeaving)
            {
                return JobStep.Done;
            }
            else
            {
                if (machine.Time.GetElapsedTime(stood) > s_longest) standby.Leave();
                else if (await StandAsync().ConfigureAwait(false) is { Ends: true } end) return end;
            }
        }
    }

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;

    private async ValueTask<JobStep> StandAsync()
    {
        machine.HasProgress(); // it stands because it is meant to
        if (await machine.PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        if (standby.Pressed is null && machine.Time.GetElapsedTime(_looked) >= (machine.Line is null ? s_betweenLooks : s_betweenSlowLooks))
        {
            standby.Seen?.Invoke(await machine.ReadAsync().ConfigureAwait(false));
            _looked = machine.Time.GetTimestamp();
        }

        for (var i = 0; i < RestsBetweenPolls && standby is { Pressed: null, IsLeaving: false }; i++) await machine.RestAsync(double.PositiveInfinity).ConfigureAwait(false);
        return JobStep.Done;
    }

    private async ValueTask<JobStep> JogAsync(JogControl control)
    {
        machine.HasProgress();
        if (await new JogMove(machine, control, limits).KeptReadyAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        if (await machine.WatchAsUsualAsync().ConfigureAwait(false) is { Ends: true } unwatched) return unwatched;
        standby.Stands(JobResult.NotStarted(0, Wording.Get("JogMove.AtRest")) with { Outcome = JobOutcome.Complete, FinalPosition = machine.State.Position, FrameOrigin = machine.FrameTaken });
        return JobStep.Done;
    }
}
