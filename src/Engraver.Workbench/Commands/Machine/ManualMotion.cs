using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>Shared by commands that move the machine manually: preconditions, target and result.</summary>
internal static class ManualMotion
{
    /// <param name="whileHeld">Also during a feed hold.</param>
    /// <exception cref="CommandException">No controller is connected, or a script may not move this machine.</exception>
    public static void ThrowIfNotReady(CommandContext context, bool whileHeld = false)
    {
        if (context.Machine.Connection.Description is not { } machine) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        if (whileHeld && context.Machine.Controls.IsHeld) return; // the operator who held the job is at the machine
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("ManualMotion.InMotion"));
        if (context.RequiresManualStart) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.ScriptCannotMove"));
        if (context.IsScripted && !context.Machine.Connection.IsSimulation && context.Machine.Arming.Armed is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.ScriptNeedsArming", machine));
    }

    /// <exception cref="CommandException">A motor is off; a manual move does not switch motors on.</exception>
    public static void ThrowIfMotorsOff(CommandContext context)
    {
        if (context.Machine.Status.MotorsOn == false) throw new CommandException(CommandFailure.Refused, Wording.Get("CncGoTo.MotorsOff"));
    }

    /// <summary>Warns if no limit stops a move at the end of the travel.</summary>
    public static void WarnUnhomed(CommandContext context)
    {
        if (context.Machine.Hand.UnhomedNotice is { } notice) context.WriteMessage(notice, MessageKind.Warning);
    }

    /// <summary>Moves to a position (<see cref="HandTarget"/>) and reports the final position.</summary>
    public static async Task MoveToAsync(CommandContext context, CountsPoint? goal, CancellationToken cancellation)
    {
        var counts = RequireCounts(goal);
        ThrowIfMotorsOff(context);
        ReportResult(context, await context.Machine.Hand.GoToAsync(counts, context.NewRunJournal("goto"), feed: null, cancellation).ConfigureAwait(false));
    }

    /// <summary>Raises the tool to the clearance height above the work; X and Y do not move.</summary>
    /// <param name="zero">Position of the drawing's zero, counts of the controller.</param>
    public static async Task ToClearanceAsync(CommandContext context, CountsPoint zero, CancellationToken cancellation)
    {
        var here = context.Machine.Status.MachinePosition ?? throw new CommandException(CommandFailure.Refused, Wording.Get("CncJog.PositionUnknown"));
        var goal = RequireCounts(HandTarget.AtClearance(here, zero, context.Machine.Profile));
        ThrowIfMotorsOff(context);
        ReportResult(context, await context.Machine.Hand.StepAsync(goal, withHeight: true, context.NewRunJournal("goto"), feed: null, cancellation).ConfigureAwait(false));
    }

    /// <summary>Moves by a step in mm from the current position.</summary>
    /// <param name="height">Step of Z, mm.</param>
    public static async Task StepAsync(CommandContext context, Vector2D step, double height, CancellationToken cancellation)
    {
        var here = context.Machine.Status.MachinePosition ?? throw new CommandException(CommandFailure.Refused, Wording.Get("CncJog.PositionUnknown"));
        var counts = RequireCounts(HandTarget.FromStep(here, context.Machine.Status.MachineHeight ?? 0.0, step, height, context.Machine.Profile.Scale));
        ThrowIfMotorsOff(context);
        WarnUnhomed(context);
        ReportResult(context, await context.Machine.Hand.StepAsync(counts, height != 0.0, context.NewRunJournal("jog"), feed: null, cancellation).ConfigureAwait(false));
    }

    /// <summary>Reports the final position.</summary>
    /// <exception cref="CommandException">The move did not finish.</exception>
    public static void ReportResult(CommandContext context, JobResult result)
    {
        foreach (var left in result.NotRestored) context.WriteMessage(Wording.Get("Machine.NotRestored", left), MessageKind.Warning);
        if (result.Outcome == JobOutcome.Refused && result.Diagnostics is [{ } refusal, ..] && result.FinalPosition is null) throw new CommandException(CommandFailure.Refused, SettingWording.AtCommandLine(refusal).Message);
        if (result.Outcome != JobOutcome.Complete) throw JobStart.Failure(result);
        if (result.FinalPosition is not { } at) return;
        context.WriteMessage(Wording.Get("CncGoTo.MachinePosition", PositionText.Format(at, context.Machine.Profile.Scale)), MessageKind.Result);
    }

    private static CountsPoint RequireCounts(CountsPoint? place) => place ?? throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.PositionOutOfRange"));
}
