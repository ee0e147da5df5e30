using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>What commands that move the machine by hand have in common: who may, where to, and how it ended.</summary>
internal static class HandMotion
{
    /// <param name="whileHeld">Also while a job stands held.</param>
    /// <exception cref="CommandException">No controller is connected, or a script may not move this machine.</exception>
    public static void Check(CommandContext context, bool whileHeld = false)
    {
        if (context.Machine.Description is not { } machine) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NoControllerConnectedCncconnect"));
        if (whileHeld && context.Machine.IsHeld) return; // whoever held the job stands at the machine
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("HandMotion.JobRuns"));
        if (context.StartIsForHands) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.ScriptDoesNotMove"));
        if (context.IsScripted && !context.Machine.IsSimulation && context.Machine.Armed is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.NothingArmedScriptCncarm", machine));
    }

    /// <exception cref="CommandException">A motor is off; a move by hand switches nothing on.</exception>
    public static void CheckMotors(CommandContext context)
    {
        if (context.Machine.Status.MotorsOn == false) throw new CommandException(CommandFailure.Refused, Wording.Get("CncGoTo.MotorsOffCncmotorsOn"));
    }

    /// <summary>Goes to a machine position, mm, and says where the machine stands.</summary>
    public static async Task GoAsync(CommandContext context, Point2D goal, CancellationToken cancellation)
    {
        var counts = Counts(context, goal);
        CheckMotors(context);
        Conclude(context, await context.Machine.GoToAsync(counts, context.NewRunJournal("goto"), feed: null, cancellation).ConfigureAwait(false));
    }

    /// <summary>Goes to a height, counts of the controller, and stays where it is in plan.</summary>
    public static async Task ToHeightAsync(CommandContext context, int height, CancellationToken cancellation)
    {
        var here = context.Machine.Status.MachinePosition ?? throw new CommandException(CommandFailure.Refused, Wording.Get("CncJog.PlaceNotKnown"));
        CheckMotors(context);
        Conclude(context, await context.Machine.StepAsync(Counts(context, here) with { Z = height }, withHeight: true, context.NewRunJournal("goto"), feed: null, cancellation).ConfigureAwait(false));
    }

    /// <summary>The same by a step in mm from where the machine stands.</summary>
    /// <param name="height">Up or down, mm.</param>
    public static async Task StepAsync(CommandContext context, Vector2D step, double height, CancellationToken cancellation)
    {
        var here = context.Machine.Status.MachinePosition ?? throw new CommandException(CommandFailure.Refused, Wording.Get("CncJog.PlaceNotKnown"));
        var (scale, top) = (context.Machine.Profile.Scale, (context.Machine.Status.MachineHeight ?? 0.0) + height);
        if (!scale.HoldsHeight(top)) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.PlaceCannotCountedController"));
        var counts = Counts(context, here + step) with { Z = scale.ToHeight(top) };
        CheckMotors(context);
        Conclude(context, await context.Machine.StepAsync(counts, height != 0.0, context.NewRunJournal("jog"), feed: null, cancellation).ConfigureAwait(false));
    }

    /// <summary>Says where the machine stands.</summary>
    /// <exception cref="CommandException">The move did not go to its end.</exception>
    public static void Conclude(CommandContext context, JobResult result)
    {
        foreach (var left in result.NotRestored) context.Say(Wording.Get("Machine.NotRestored", left), MessageKind.Warning);
        if (result.Outcome == JobOutcome.Refused && result.Diagnostics is [{ } refusal, ..] && result.FinalPosition is null) throw new CommandException(CommandFailure.Refused, SettingWording.AtCommandLine(refusal).Message);
        if (result.Outcome != JobOutcome.Complete) throw JobStart.Failure(result);
        if (result.FinalPosition is not { } at) return;
        context.Say(Wording.Get("CncGoTo.MachineStandsMm", PlaceText.Show(at, context.Machine.Profile.Scale)), MessageKind.Result);
    }

    private static CountsPoint Counts(CommandContext context, Point2D machine)
    {
        var scale = context.Machine.Profile.Scale;
        return scale.Holds(Bounds2D.FromCorners(machine, machine), default) ? scale.ToCounts(machine) : throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.PlaceCannotCountedController"));
    }
}
