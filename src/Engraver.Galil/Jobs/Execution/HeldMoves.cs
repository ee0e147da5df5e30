using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Language;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Moves by hand while a job stands held and nothing of it is under way in the controller: under the job's own watchdog and stop, tool off or
/// up.</summary>
/// <param name="limits">The travel that is in force, counts; empty where none is known.</param>
/// <param name="moved">Told when the machine stands where a move has brought it, before the operator is.</param>
internal sealed class HeldMoves(JobMachine machine, JobControl control, IReadOnlyList<SoftLimit> limits, Action moved)
{
    /// <summary>Makes a move and tells the operator how it ended. What ends a move, such as a limit switch, does not end the job as long as the next look
    /// finds the machine as it should be.</summary>
    public async ValueTask<JobStep> MakeAsync(HeldMove move)
    {
        var goal = move.GoalFrom(machine.State.Position);
        if (move.Jog is null && limits.Count > 0 && TravelLimits.Refusal(machine.Profile, goal, move.WithHeight) is { } outside)
        {
            control.MoveEnds(JobResult.NotStarted(0, outside.Message) with { Diagnostics = [outside] });
            return JobStep.Done;
        }

        var made = move.Jog is { } jog ? await JogAsync(jog).ConfigureAwait(false) : await new HandMove(machine, goal, move.WithHeight, SpeedOf(move)).CutAsync().ConfigureAwait(false);
        if (made.Ends && await RestAsync().ConfigureAwait(false) is { Ends: true } broken) return broken;
        moved();
        control.MoveEnds(Result(made));
        return JobStep.Done;
    }

    /// <summary>As long as the key is held, and until the job is to go on. The dead-man of a jog is in force meanwhile.</summary>
    private async ValueTask<JobStep> JogAsync(JogControl jog)
    {
        var made = await new JogMove(machine, jog, limits, () => jog.Released.IsCompleted || !control.IsHoldWanted).CutAsync().ConfigureAwait(false);
        return await machine.WatchAsUsualAsync().ConfigureAwait(false) is { Ends: true } unwatched && !made.Ends ? unwatched : made;
    }

    private async ValueTask<JobStep> RestAsync()
    {
        if (await machine.SendAsync("ST " + machine.Profile.Axes.Letters).ConfigureAwait(false) is { Ends: true } refused) return refused;
        return await machine.PollUntilAsync(state => state.Stands).ConfigureAwait(false);
    }

    private static Func<MachineAxis, int>? SpeedOf(HeldMove move) => move.MmPerMinute is { } speed ? axis => axis.AxisSpeed(speed) : null;

    private JobResult Result(JobStep made) => JobResult.NotStarted(0, made.Ends ? made.Sentence : Wording.Get("HeldMoves.Moved")) with
    {
        Outcome = made.Outcome,
        Refusal = made.Refusal?.ToRefusal(),
        FinalPosition = machine.State.Position,
    };
}
