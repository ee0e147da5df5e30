using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>A move between two strokes, each axis at its own speed (PA, BG), commanded by this computer in stream and calls mode. The tool is off.</summary>
internal static class RapidMove
{
    /// <summary>Moves to a point of the job frame and waits until the machine is at rest there; only axes that have to move are begun.</summary>
    public static ValueTask<JobStep> ToAsync(JobMachine machine, CountsPoint target) => ToMachineAsync(machine, new CountsPoint(target.X + machine.Frame.X, target.Y + machine.Frame.Y));

    /// <summary>The same to a point in the controller's own counts.</summary>
    public static async ValueTask<JobStep> ToMachineAsync(JobMachine machine, CountsPoint goal)
    {
        if (await machine.PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        var from = machine.State.Position;
        var axes = Moving(machine.Profile.Axes, from, goal);
        if (axes.Count == 0) return JobStep.Done;
        if (await machine.SendAllAsync(axes.SelectMany(axis => Commands(machine.Profile, axis.Axis, axis.Goal))).ConfigureAwait(false) is { Ends: true } refused) return refused;
        if (await SettingCheck.ReadBackAsync(machine, [.. axes.Select(axis => ($"_SP{axis.Axis.Letter}", (double)machine.Profile.RapidSpeed(axis.Axis), SettingCheck.Speed))]).ConfigureAwait(false) is { Ends: true } harmed) return harmed;
        if (await GoAsync(machine, from, goal, string.Concat(axes.Select(axis => axis.Axis.Letter))).ConfigureAwait(false) is { Ends: true } broken) return broken;
        var at = machine.State.Position;
        return at == goal
            ? JobStep.Done
            : JobStep.Broken(Wording.Get("RapidMove.RapidEndedFindOut", goal.X, goal.Y, at.X, at.Y, StopCodes.Text(machine.State.StopCode)));
    }

    private static async ValueTask<JobStep> GoAsync(JobMachine machine, CountsPoint from, CountsPoint goal, string axes)
    {
        if (await machine.SendAsync("BG" + axes).ConfigureAwait(false) is { Ends: true } unbegun) return unbegun;
        machine.Expectation = state => IsBetween(from.X, state.Position.X, goal.X) && IsBetween(from.Y, state.Position.Y, goal.Y)
            ? JobStep.Done
            : JobStep.Deviated(Wording.Get("RapidMove.RapidFromWentCounts", from.X, from.Y, goal.X, goal.Y, state.Position.X, state.Position.Y));
        try
        {
            return await machine.PollUntilAsync(state => state.Stands, Seconds(machine, from, goal)).ConfigureAwait(false);
        }
        finally
        {
            machine.Expectation = null;
        }
    }

    private static double Seconds(JobMachine machine, CountsPoint from, CountsPoint goal)
    {
        double Axis(double counts, int speed) => SpeedTrapezoid.Time(Math.Abs(counts), speed, machine.Profile.AccelerationCounts);
        var (profile, axes) = (machine.Profile, machine.Profile.Axes);
        return Math.Max(Axis((double)goal.X - from.X, profile.RapidSpeed(axes.X)), Axis((double)goal.Y - from.Y, profile.RapidSpeed(axes.Y)));
    }

    private static bool IsBetween(int from, int at, int to) => at >= Math.Min(from, to) && at <= Math.Max(from, to);

    /// <summary>SP and PA of one axis.</summary>
    public static IReadOnlyList<string> Commands(MachineProfile profile, MachineAxis axis, int goal) => [Text($"SP{axis.Letter}={profile.RapidSpeed(axis)}"), Text($"PA{axis.Letter}={goal}")];

    /// <summary>The axes with something to do, and where they go.</summary>
    public static IReadOnlyList<(MachineAxis Axis, int Goal)> Moving(MachineAxes axes, CountsPoint from, CountsPoint goal)
    {
        var moving = new List<(MachineAxis Axis, int Goal)>();
        if (goal.X != from.X) moving.Add((axes.X, goal.X));
        if (goal.Y != from.Y) moving.Add((axes.Y, goal.Y));
        return moving;
    }
}

/// <summary>A move without cutting: a rapid to one point in the controller's own counts, under the watchdog and the stop of a job. The tool is off throughout.</summary>
internal sealed class HandMove(JobMachine machine, CountsPoint goal) : IJobStrategy
{
    public ValueTask<JobStep> StartAsync() => new(JobStep.Done);

    public ValueTask<JobStep> CutAsync() => RapidMove.ToMachineAsync(machine, goal);

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;
}
