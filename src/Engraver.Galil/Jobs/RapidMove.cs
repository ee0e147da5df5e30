using Engraver.Galil.Programs;
using Engraver.Galil.Protocol;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs;

/// <summary>A move between two strokes, each axis at its own speed (PA, BG); in both ways the host makes it itself. The tool is off.</summary>
internal static class RapidMove
{
    /// <summary>Goes to a point of the job frame and waits until the machine stands there; only an axis with something to do is begun.</summary>
    public static ValueTask<JobStep> ToAsync(JobMachine machine, CountsPoint target) => ToMachineAsync(machine, new CountsPoint(target.X + machine.Frame.X, target.Y + machine.Frame.Y));

    /// <summary>The same to a place of the controller's own counts.</summary>
    public static async ValueTask<JobStep> ToMachineAsync(JobMachine machine, CountsPoint goal)
    {
        if (await machine.PollAsync().ConfigureAwait(false) is { Ends: true } end) return end;
        var commands = Commands(machine, goal);
        if (commands.Count == 0) return JobStep.Done;
        if (await machine.SendAllAsync(commands).ConfigureAwait(false) is { Ends: true } refused) return refused;
        if (await machine.PollUntilAsync(state => state.Stands).ConfigureAwait(false) is { Ends: true } broken) return broken;
        var at = machine.State.Position;
        return at == goal
            ? JobStep.Done
            : JobStep.Broken(Text($"The rapid to {goal.X},{goal.Y} ended at {at.X},{at.Y} ({StopCodes.Text(machine.State.StopCode)}); find out what stopped the axis."));
    }

    private static List<string> Commands(JobMachine machine, CountsPoint goal)
    {
        var commands = new List<string>();
        var axes = "";
        if (goal.X != machine.State.Position.X)
        {
            commands.AddRange([Text($"SPA={machine.Profile.RapidSpeedX}"), Text($"PAA={goal.X}")]);
            axes += "A";
        }

        if (goal.Y != machine.State.Position.Y)
        {
            commands.AddRange([Text($"SPB={machine.Profile.RapidSpeedY}"), Text($"PAB={goal.Y}")]);
            axes += "B";
        }

        if (axes.Length > 0) commands.Add("BG" + axes);
        return commands;
    }
}
