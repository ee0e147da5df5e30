using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
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
        if (context.Machine.Connection.Description is not { } machine) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        if (whileHeld && context.Machine.Controls.IsHeld) return; // whoever held the job stands at the machine
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("HandMotion.InMotion"));
        if (context.StartIsForHands) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.ScriptCannotMove"));
        if (context.IsScripted && !context.Machine.Connection.IsSimulation && context.Machine.Arming.Armed is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.ScriptNeedsArming", machine));
    }

    /// <exception cref="CommandException">A motor is off; a move by hand switches nothing on.</exception>
    public static void CheckMotors(CommandContext context)
    {
        if (context.Machine.Status.MotorsOn == false) throw new CommandException(CommandFailure.Refused, Wording.Get("CncGoTo.MotorsOff"));
    }

    /// <summary>Says that nothing stops a move at the end of the travel, where that is so.</summary>
    public static void TellUnhomed(CommandContext context)
    {
        if (context.Machine.Hand.UnhomedNotice is { } notice) context.Say(notice, MessageKind.Warning);
    }

    /// <summary>Goes to a place (<see cref="HandPlace"/>) and says where the machine stands.</summary>
    public static async Task GoAsync(CommandContext context, CountsPoint? goal, CancellationToken cancellation)
    {
        var counts = Counted(goal);
        CheckMotors(context);
        Conclude(context, await context.Machine.Hand.GoToAsync(counts, context.NewRunJournal("goto"), feed: null, cancellation).ConfigureAwait(false));
    }

    /// <summary>Brings the tool to the clearance height over the work, and stays where it is in plan.</summary>
    /// <param name="zero">Where the drawing's zero lies, counts of the controller.</param>
    public static async Task ToClearanceAsync(CommandContext context, CountsPoint zero, CancellationToken cancellation)
    {
        var here = context.Machine.Status.MachinePosition ?? throw new CommandException(CommandFailure.Refused, Wording.Get("CncJog.PositionUnknown"));
        var goal = Counted(HandPlace.AtClearance(here, zero, context.Machine.Profile));
        CheckMotors(context);
        Conclude(context, await context.Machine.Hand.StepAsync(goal, withHeight: true, context.NewRunJournal("goto"), feed: null, cancellation).ConfigureAwait(false));
    }

    /// <summary>The same by a step in mm from where the machine stands.</summary>
    /// <param name="height">Up or down, mm.</param>
    public static async Task StepAsync(CommandContext context, Vector2D step, double height, CancellationToken cancellation)
    {
        var here = context.Machine.Status.MachinePosition ?? throw new CommandException(CommandFailure.Refused, Wording.Get("CncJog.PositionUnknown"));
        var counts = Counted(HandPlace.Beside(here, context.Machine.Status.MachineHeight ?? 0.0, step, height, context.Machine.Profile.Scale));
        CheckMotors(context);
        TellUnhomed(context);
        Conclude(context, await context.Machine.Hand.StepAsync(counts, height != 0.0, context.NewRunJournal("jog"), feed: null, cancellation).ConfigureAwait(false));
    }

    /// <summary>Says where the machine stands.</summary>
    /// <exception cref="CommandException">The move did not go to its end.</exception>
    public static void Conclude(CommandContext context, JobResult result)
    {
        foreach (var left in result.NotRestored) context.Say(Wording.Get("Machine.NotRestored", left), MessageKind.Warning);
        if (result.Outcome == JobOutcome.Refused && result.Diagnostics is [{ } refusal, ..] && result.FinalPosition is null) throw new CommandException(CommandFailure.Refused, SettingWording.AtCommandLine(refusal).Message);
        if (result.Outcome != JobOutcome.Complete) throw JobStart.Failure(result);
        if (result.FinalPosition is not { } at) return;
        context.Say(Wording.Get("CncGoTo.MachinePosition", PlaceText.Show(at, context.Machine.Profile.Scale)), MessageKind.Result);
    }

    private static CountsPoint Counted(CountsPoint? place) => place ?? throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.PositionOutOfRange"));
}
