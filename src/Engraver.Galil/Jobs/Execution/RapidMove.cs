using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Watching;
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
        var axes = (goal.X != from.X ? "A" : "") + (goal.Y != from.Y ? "B" : "");
        if (axes.Length == 0) return JobStep.Done;
        if (await machine.SendAllAsync(Commands(machine, goal, axes)).ConfigureAwait(false) is { Ends: true } refused) return refused;
        if (await SettingCheck.ReadBackAsync(machine, [.. axes.Select(axis => ($"_SP{axis}", (double)Speed(machine, axis), SettingCheck.Speed))]).ConfigureAwait(false) is { Ends: true } harmed) return harmed;
        if (await GoAsync(machine, from, goal, axes).ConfigureAwait(false) is { Ends: true } broken) return broken;
        var at = machine.State.Position;
        return at == goal
            ? JobStep.Done
            : JobStep.Broken(Text($"The rapid to {goal.X},{goal.Y} ended at {at.X},{at.Y} ({StopCodes.Text(machine.State.StopCode)}); find out what stopped the axis."));
    }

    private static async ValueTask<JobStep> GoAsync(JobMachine machine, CountsPoint from, CountsPoint goal, string axes)
    {
        if (await machine.SendAsync("BG" + axes).ConfigureAwait(false) is { Ends: true } unbegun) return unbegun;
        machine.Expectation = state => IsBetween(from.X, state.Position.X, goal.X) && IsBetween(from.Y, state.Position.Y, goal.Y)
            ? JobStep.Done
            : JobStep.Deviated(Text($"The rapid from {from.X},{from.Y} to {goal.X},{goal.Y} went to {state.Position.X},{state.Position.Y} (counts of the controller); what was sent has not arrived as it was sent. Look at the cable and who else uses the controller."));
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
        return Math.Max(Axis((double)goal.X - from.X, machine.Profile.RapidSpeedX), Axis((double)goal.Y - from.Y, machine.Profile.RapidSpeedY));
    }

    private static bool IsBetween(int from, int at, int to) => at >= Math.Min(from, to) && at <= Math.Max(from, to);

    private static List<string> Commands(JobMachine machine, CountsPoint goal, string axes)
    {
        var commands = new List<string>();
        foreach (var axis in axes) commands.AddRange([Text($"SP{axis}={Speed(machine, axis)}"), Text($"PA{axis}={(axis == 'A' ? goal.X : goal.Y)}")]);
        return commands;
    }

    private static int Speed(JobMachine machine, char axis) => axis == 'A' ? machine.Profile.RapidSpeedX : machine.Profile.RapidSpeedY;
}

/// <summary>A move without cutting: a rapid to one point in the controller's own counts, under the watchdog and the stop of a job. The tool is off throughout.</summary>
internal sealed class HandMove(JobMachine machine, CountsPoint goal) : IJobStrategy
{
    public ValueTask<JobStep> StartAsync() => new(JobStep.Done);

    public ValueTask<JobStep> CutAsync() => RapidMove.ToMachineAsync(machine, goal);

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;
}
