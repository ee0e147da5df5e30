using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Language;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Moves by hand while a job is held and the controller executes no part of it: with the job's own watchdog and stop, tool off or
/// raised.</summary>
/// <param name="limits">The travel that is in force, counts; empty where it is not known.</param>
internal sealed class HeldMoves(JobMachine machine, JobControl control, JobLog log, IReadOnlyList<SoftLimit> limits)
{
    /// <summary>Makes a move and reports how it ended: first to the journal, then to the operator. What ends a move, such as a limit switch, does not end
    /// the job as long as the next poll finds the machine as it should be.</summary>
    public async ValueTask MakeAsync(MoveInHold move)
    {
        var goal = move.GoalFrom(machine.State.Position);
        if (move.Jog is null && limits.Count > 0 && TravelLimits.Refusal(machine.Profile, goal, move.WithHeight) is { } outside)
        {
            control.CompleteMove(JobResult.NotStarted(0, outside.Message) with { Diagnostics = [outside] });
            return;
        }

        var early = move.Jog is { } jog ? await JogAsync(jog).ConfigureAwait(false) : await JobEnd.OfAsync(new HandMove(machine, goal, move.WithHeight, SpeedOf(move)).CutAsync).ConfigureAwait(false);
        if (early is not null) await BrakeToRestAsync().ConfigureAwait(false);
        log.ControlChanged(machine);
        control.CompleteMove(Result(early ?? JobEnd.Complete(Wording.Get("HeldMoves.Moved"))));
    }

    /// <summary>As long as the key is held, and until the job is to continue. The short watchdog time of a jog is in force meanwhile.</summary>
    /// <returns>How it ended early; null for the end of a jog.</returns>
    private async ValueTask<JobEnd?> JogAsync(JogControl jog)
    {
        var early = await JobEnd.OfAsync(new JogMove(machine, jog, limits, () => jog.Released.IsCompleted || !control.IsHoldWanted).CutAsync).ConfigureAwait(false);
        var unwatched = await JobEnd.OfAsync(machine.Commands.WatchAsUsualAsync).ConfigureAwait(false);
        return early ?? unwatched;
    }

    private async ValueTask BrakeToRestAsync()
    {
        await machine.Commands.SendAsync(machine.BrakeCommand).ConfigureAwait(false);
        await machine.PollUntilAsync(state => state.IsAtRest).ConfigureAwait(false);
    }

    private static Func<MachineAxis, int>? SpeedOf(MoveInHold move) => move.MmPerMinute is { } speed ? axis => axis.AxisSpeed(speed) : null;

    private JobResult Result(JobEnd end) => JobResult.NotStarted(0, end.Sentence) with
    {
        Outcome = end.Outcome,
        Refusal = end.Refusal?.ToRefusal(),
        FinalPosition = machine.State.Position,
    };
}
