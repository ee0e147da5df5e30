using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCGOTO: Moves the machine at rapid speed with the tool off: to a machine position, or back to where the last run of this drawing started.</summary>
internal sealed class CncGoToCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("Start");

    public CommandInfo Info { get; } = new("CNCGOTO", CommandGroup.Machine, "Moves the machine at rapid speed with the tool off: to a machine position in mm, or back to where the last run of this drawing started. A script moves a real machine only after CNCARM, and not in the desktop.") { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Description is not { } machine) throw new CommandException(CommandFailure.Usage, "No controller is connected; CNCCONNECT first.");
        if (context.StartIsForHands) throw new CommandException(CommandFailure.Usage, "A script does not move a real machine from the desktop; CNCGOTO typed by hand does.");
        if (context.IsScripted && !context.Machine.IsSimulation && context.Machine.Armed is null) throw new CommandException(CommandFailure.Usage, $"Nothing is armed for {machine}; in a script CNCARM comes first.");
        var answer = await context.AskAsync(new MachinePlacePrompt("Specify machine position in mm") { Options = s_options }).ConfigureAwait(false);
        var goal = answer is Answer<MachinePlace>.Value { Of: var place } ? Counts(context, place) : StartOfLastRun(context);
        if (context.Machine.Status.MotorsOn == false) throw new CommandException(CommandFailure.Refused, "The motors are off; CNCMOTORS ON.");
        var result = await context.Machine.GoToAsync(goal, context.NewRunJournal("goto"), cancellation).ConfigureAwait(false);
        foreach (var left in result.NotRestored) context.Say($"not restored: {left}", MessageKind.Warning);
        if (result.Outcome != JobOutcome.Complete) throw JobStart.Failure(result);
        var at = result.FinalPosition!.Value;
        var scale = context.Machine.Profile.Scale;
        context.Say($"The machine stands at {PointPrompt.Show(new Point2D(at.X / scale.X, at.Y / scale.Y))} mm.", MessageKind.Result);
    }

    private static CountsPoint Counts(CommandContext context, MachinePlace place)
    {
        var at = new Point2D(place.X, place.Y);
        var scale = context.Machine.Profile.Scale;
        return scale.Holds(Bounds2D.FromCorners(at, at), default) ? scale.ToCounts(at) : throw new CommandException(CommandFailure.Usage, "That place cannot be counted in the controller's 32 bits; give one nearer to its zero.");
    }

    /// <exception cref="CommandException">No drawing is open, or no run of it on this controller is known.</exception>
    private static CountsPoint StartOfLastRun(CommandContext context)
    {
        var (drawing, settings) = (context.Drawing, context.Document.Current.Settings);
        return context.Machine.LastStart(drawing) is { } last
            ? StartPlace.Locate(last, settings)
            : throw new CommandException(CommandFailure.Usage, "This drawing has not been run on this controller, as far as is known here; give a machine position x,y.");
    }
}
