using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCGOTO: Moves the machine at rapid speed with the tool off: to a machine position, a place of the drawing, the drawing's start point or the park position.</summary>
internal sealed class CncGoToCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("Work", "Start", "Park");

    public CommandInfo Info { get; } = new("CNCGOTO", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Description is not { } machine) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NoControllerConnectedCncconnect"));
        if (context.StartIsForHands) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.ScriptDoesNotMove"));
        if (context.IsScripted && !context.Machine.IsSimulation && context.Machine.Armed is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.NothingArmedScriptCncarm", machine));
        var answer = await context.AskAsync(new MachinePlacePrompt(Wording.Get("CncGoTo.SpecifyMachinePositionMm")) { Options = s_options }).ConfigureAwait(false);
        var goal = answer switch
        {
            Answer<MachinePlace>.Value { Of: var place } => Counts(context, new Point2D(place.X, place.Y)),
            Answer<MachinePlace>.Chosen { Option: "Work" } => Counts(context, Machine(context, await context.ValueAsync(new PointPrompt(Wording.Get("CncGoTo.SpecifyPlaceDrawing"))).ConfigureAwait(false))),
            Answer<MachinePlace>.Chosen { Option: "Park" } => Counts(context, context.Machine.Profile.Park ?? throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.NoParkPosition"))),
            _ => Counts(context, Machine(context, context.Document.Current.Settings.Start)),
        };
        if (context.Machine.Status.MotorsOn == false) throw new CommandException(CommandFailure.Refused, Wording.Get("CncGoTo.MotorsOffCncmotorsOn"));
        var result = await context.Machine.GoToAsync(goal, context.NewRunJournal("goto"), feed: null, cancellation).ConfigureAwait(false);
        foreach (var left in result.NotRestored) context.Say(Wording.Get("Machine.NotRestored", left), MessageKind.Warning);
        if (result.Outcome != JobOutcome.Complete) throw JobStart.Failure(result);
        var at = result.FinalPosition!.Value;
        var scale = context.Machine.Profile.Scale;
        context.Say(Wording.Get("CncGoTo.MachineStandsMm", PointPrompt.Show(new Point2D(at.X / scale.X, at.Y / scale.Y))), MessageKind.Result);
    }

    private static CountsPoint Counts(CommandContext context, Point2D machine)
    {
        var scale = context.Machine.Profile.Scale;
        return scale.Holds(Bounds2D.FromCorners(machine, machine), default) ? scale.ToCounts(machine) : throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.PlaceCannotCountedController"));
    }

    /// <summary>A place of the drawing as machine millimetres, through the active work origin.</summary>
    /// <exception cref="CommandException">The origin is not set.</exception>
    private static Point2D Machine(CommandContext context, Point2D drawing)
    {
        var memory = context.Machine.Hold!.Memory;
        var scale = context.Machine.Profile.Scale;
        return memory.ActiveOrigin?.Plane is { } zero
            ? new Point2D((zero.X / scale.X) + drawing.X, (zero.Y / scale.Y) + drawing.Y)
            : throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.OriginNotSet", memory.Active));
    }
}
