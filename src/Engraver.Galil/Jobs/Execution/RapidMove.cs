using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>A move between two strokes, each axis at its own speed (PA, BG), commanded by this computer in stream and calls mode. The tool is off.</summary>
internal static class RapidMove
{
    /// <summary>Moves to a point of the job frame and waits until the machine is at rest there; only axes that have to move are started.</summary>
    /// <remarks>In X and Y: before it the tool is at clearance height or above, where an axis drives it; the height does not change then.</remarks>
    public static async ValueTask ToAsync(JobMachine machine, CountsPoint target)
    {
        await machine.Tool.ClearAsync().ConfigureAwait(false);
        await ToMachineAsync(machine, target + machine.Frame.Origin).ConfigureAwait(false);
    }

    /// <summary>The same to a point in the controller's own counts: in X and Y, at any height of the tool.</summary>
    /// <param name="speed">SP of each axis; null for rapid speed.</param>
    public static async ValueTask ToMachineAsync(JobMachine machine, CountsPoint goal, Func<MachineAxis, int>? speed = null)
    {
        await machine.Hold.GateAsync().ConfigureAwait(false);
        await machine.PollAsync().ConfigureAwait(false);
        await MoveAsync(machine, goal with { Z = machine.State.Position.Z }, speed ?? machine.Speed.RapidSpeed).ConfigureAwait(false);
    }

    /// <summary>Moves the Z axis alone.</summary>
    /// <param name="height">The controller's own counts.</param>
    /// <param name="speed">SP of the axis; null for rapid speed.</param>
    public static ValueTask ToHeightAsync(JobMachine machine, int height, Func<MachineAxis, int>? speed = null) =>
        MoveAsync(machine, machine.State.Position with { Z = height }, speed ?? machine.Speed.RapidSpeed);

    /// <param name="speed">SP of an axis, counts/s.</param>
    private static async ValueTask MoveAsync(JobMachine machine, CountsPoint goal, Func<MachineAxis, int> speed)
    {
        var from = machine.State.Position;
        var axes = Moving(machine.Profile.Axes, from, goal);
        if (axes.Count == 0) return;
        await machine.Settings.SendRapidsAsync(axes.Select(axis => (axis.Axis.Letter, speed(axis.Axis)))).ConfigureAwait(false);
        await machine.Commands.SendAllAsync(axes.Select(axis => GoalOf(axis.Axis, axis.Goal))).ConfigureAwait(false);
        var seconds = machine.Profile.Axes.All.Select((axis, i) => SpeedTrapezoid.Time(Math.Abs((double)goal[i] - from[i]), speed(axis), machine.Profile.AccelerationCounts)).Max();
        await machine.Commands.SendAsync("BG" + string.Concat(axes.Select(axis => axis.Axis.Letter))).ConfigureAwait(false);
        using (machine.Enter(machine.Phase with { Expected = state => OffWay(machine, from, state.Position, goal) })) await machine.PollUntilAsync(state => state.IsAtRest, seconds).ConfigureAwait(false);
        var at = machine.State.Position;
        if (at == goal) return;
        var why = await machine.Watch.Fault.WhyStoppedAsync().ConfigureAwait(false);
        throw JobEnd.Broken(at.IsSameInPlan(goal) ? Wording.Get("RapidMove.HeightNotReached", goal.Z, at.Z, why) : Wording.Get("RapidMove.EndedEarly", goal.X, goal.Y, at.X, at.Y, why)).ToException();
    }

    /// <summary>Why the job ends where an axis is not between start and goal; null where each is.</summary>
    private static JobEnd? OffWay(JobMachine machine, CountsPoint from, CountsPoint at, CountsPoint goal) =>
        machine.Profile.Axes.All.Select((_, i) => IsBetween(from[i], at[i], goal[i])).All(isBetween => isBetween)
            ? null
            : JobEnd.Deviated(Wording.Get("RapidMove.WrongEndPoint", from.X, from.Y, goal.X, goal.Y, at.X, at.Y));

    private static bool IsBetween(long from, long at, long to) => at >= Math.Min(from, to) && at <= Math.Max(from, to);

    /// <summary>PA of one axis.</summary>
    public static string GoalOf(MachineAxis axis, long goal) => DmcFormat.Text($"PA{axis.Letter}={goal}");

    /// <summary>The axes that have to move, and where they go.</summary>
    public static IReadOnlyList<(MachineAxis Axis, long Goal)> Moving(MachineAxes axes, CountsPoint from, CountsPoint goal) =>
        [.. axes.All.Select((axis, i) => (Axis: axis, Goal: goal[i], IsThere: goal[i] == from[i])).Where(move => !move.IsThere).Select(move => (move.Axis, move.Goal))];
}
