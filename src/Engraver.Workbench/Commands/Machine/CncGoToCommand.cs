using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCGOTO: Moves the machine at rapid speed with the tool off: to a machine position, or back to where the last run of this drawing started.</summary>
internal sealed class CncGoToCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("Start");

    public CommandInfo Info { get; } = new("CNCGOTO", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Description is not { } machine) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NoControllerConnectedCncconnect"));
        if (context.StartIsForHands) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.ScriptDoesNotMove"));
        if (context.IsScripted && !context.Machine.IsSimulation && context.Machine.Armed is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.NothingArmedScriptCncarm", machine));
        var answer = await context.AskAsync(new MachinePlacePrompt(Wording.Get("CncGoTo.SpecifyMachinePositionMm")) { Options = s_options }).ConfigureAwait(false);
        var goal = answer is Answer<MachinePlace>.Value { Of: var place } ? Counts(context, place) : StartOfLastRun(context);
        if (context.Machine.Status.MotorsOn == false) throw new CommandException(CommandFailure.Refused, Wording.Get("CncGoTo.MotorsOffCncmotorsOn"));
        var result = await context.Machine.GoToAsync(goal, context.NewRunJournal("goto"), cancellation).ConfigureAwait(false);
        foreach (var left in result.NotRestored) context.Say(Wording.Get("Machine.NotRestored", left), MessageKind.Warning);
        if (result.Outcome != JobOutcome.Complete) throw JobStart.Failure(result);
        var at = result.FinalPosition!.Value;
        var scale = context.Machine.Profile.Scale;
        context.Say(Wording.Get("CncGoTo.MachineStandsMm", PointPrompt.Show(new Point2D(at.X / scale.X, at.Y / scale.Y))), MessageKind.Result);
    }

    private static CountsPoint Counts(CommandContext context, MachinePlace place)
    {
        var at = new Point2D(place.X, place.Y);
        var scale = context.Machine.Profile.Scale;
        return scale.Holds(Bounds2D.FromCorners(at, at), default) ? scale.ToCounts(at) : throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.PlaceCannotCountedController"));
    }

    /// <exception cref="CommandException">No drawing is open, or no run of it on this controller is known.</exception>
    private static CountsPoint StartOfLastRun(CommandContext context)
    {
        var (drawing, settings) = (context.Drawing, context.Document.Current.Settings);
        return context.Machine.LastStart(drawing) is { } last
            ? StartPlace.Locate(last, settings)
            : throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.DrawingHasNotBeen"));
    }
}
