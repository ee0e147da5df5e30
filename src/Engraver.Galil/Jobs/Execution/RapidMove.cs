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
    /// <remarks>In plan: first the tool is at clearance height or above, where an axis holds it; then the height stays.</remarks>
    public static async ValueTask<JobStep> ToAsync(JobMachine machine, CountsPoint target) =>
        await machine.Tool.ClearAsync().ConfigureAwait(false) is { Ends: true } down ? down : await ToMachineAsync(machine, target + machine.Frame).ConfigureAwait(false);

    /// <summary>The same to a point in the controller's own counts: in plan, at whatever height the tool is.</summary>
    /// <param name="speed">SP of each axis; null for rapid speed.</param>
    public static async ValueTask<JobStep> ToMachineAsync(JobMachine machine, CountsPoint goal, Func<MachineAxis, int>? speed = null)
    {
        if (await machine.Hold.GateAsync().ConfigureAwait(false) is { Ends: true } held) return held;
        if (await machine.PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        return await MoveAsync(machine, goal with { Z = machine.State.Position.Z }, speed ?? machine.Hold.RapidSpeed).ConfigureAwait(false);
    }

    /// <summary>Moves the Z axis alone.</summary>
    /// <param name="height">The controller's own counts.</param>
    /// <param name="speed">SP of the axis; null for rapid speed.</param>
    public static ValueTask<JobStep> ToHeightAsync(JobMachine machine, int height, Func<MachineAxis, int>? speed = null) =>
        MoveAsync(machine, machine.State.Position with { Z = height }, speed ?? machine.Hold.RapidSpeed);

    /// <param name="speed">SP of an axis, counts/s.</param>
    private static async ValueTask<JobStep> MoveAsync(JobMachine machine, CountsPoint goal, Func<MachineAxis, int> speed)
    {
        var from = machine.State.Position;
        var axes = Moving(machine.Profile.Axes, from, goal);
        if (axes.Count == 0) return JobStep.Done;
        if (await machine.SendAllAsync(axes.SelectMany(axis => Commands(axis.Axis, axis.Goal, speed(axis.Axis)))).ConfigureAwait(false) is { Ends: true } refused) return refused;
        if (await SettingCheck.ReadBackAsync(machine, [.. axes.Select(axis => ($"_SP{axis.Axis.Letter}", (double)speed(axis.Axis), SettingCheck.Speed))]).ConfigureAwait(false) is { Ends: true } harmed) return harmed;
        var seconds = machine.Profile.Axes.All.Select((axis, i) => SpeedTrapezoid.Time(Math.Abs((double)goal[i] - from[i]), speed(axis), machine.Profile.AccelerationCounts)).Max();
        if (await GoAsync(machine, from, goal, string.Concat(axes.Select(axis => axis.Axis.Letter)), seconds).ConfigureAwait(false) is { Ends: true } broken) return broken;
        var at = machine.State.Position;
        return at == goal
            ? JobStep.Done
            : JobStep.Broken(at.IsBeside(goal)
                ? Wording.Get("RapidMove.HeightNotReached", goal.Z, at.Z, await machine.WhyStoppedAsync().ConfigureAwait(false))
                : Wording.Get("RapidMove.EndedEarly", goal.X, goal.Y, at.X, at.Y, await machine.WhyStoppedAsync().ConfigureAwait(false)));
    }

    private static async ValueTask<JobStep> GoAsync(JobMachine machine, CountsPoint from, CountsPoint goal, string axes, double seconds)
    {
        if (await machine.SendAsync("BG" + axes).ConfigureAwait(false) is { Ends: true } unbegun) return unbegun;
        machine.Expectation = state => machine.Profile.Axes.All.Select((_, i) => IsBetween(from[i], state.Position[i], goal[i])).All(isBetween => isBetween)
            ? JobStep.Done
            : JobStep.Deviated(Wording.Get("RapidMove.WrongEndPoint", from.X, from.Y, goal.X, goal.Y, state.Position.X, state.Position.Y));
        try
        {
            return await machine.PollUntilAsync(state => state.Stands, seconds).ConfigureAwait(false);
        }
        finally
        {
            machine.Expectation = null;
        }
    }

    private static bool IsBetween(long from, long at, long to) => at >= Math.Min(from, to) && at <= Math.Max(from, to);

    /// <summary>SP and PA of one axis.</summary>
    public static IReadOnlyList<string> Commands(MachineAxis axis, long goal, int speed) => [Text($"SP{axis.Letter}={speed}"), Text($"PA{axis.Letter}={goal}")];

    /// <summary>The axes with something to do, and where they go.</summary>
    public static IReadOnlyList<(MachineAxis Axis, long Goal)> Moving(MachineAxes axes, CountsPoint from, CountsPoint goal) =>
        [.. axes.All.Select((axis, i) => (Axis: axis, Goal: goal[i], IsThere: goal[i] == from[i])).Where(move => !move.IsThere).Select(move => (move.Axis, move.Goal))];
}
