using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCGOTO: Moves the machine at rapid speed with the tool off: to a machine position, a point of the drawing, the drawing's start point or the park
/// position. A tool axis is raised to its clearance height above the work first; the option Clearance does only that.</summary>
internal sealed class CncGoToCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("Work", "Start", "Park", "Clearance");

    public CommandInfo Info { get; } = new("CNCGOTO", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        ManualMotion.ThrowIfNotReady(context);
        var answer = await context.AskAsync(new MachinePositionPrompt(Wording.Get("CncGoTo.SpecifyMachinePosition")) { Options = s_options }).ConfigureAwait(false);
        if (answer is Answer<TypedMachinePosition>.SelectedOption { Option: "Clearance" })
        {
            await ClearAsync(context, cancellation).ConfigureAwait(false);
            return;
        }

        var scale = context.Machine.Profile.Scale;
        var goal = answer switch
        {
            Answer<TypedMachinePosition>.Value { Result: var place } => HandTarget.OfMachine(new Point2D(place.X, place.Y), scale),
            Answer<TypedMachinePosition>.SelectedOption { Option: "Work" } => await OfDrawingAsync(context, await context.ValueAsync(new PointPrompt(Wording.Get("CncGoTo.SpecifyDrawingPoint"))).ConfigureAwait(false), cancellation).ConfigureAwait(false),
            Answer<TypedMachinePosition>.SelectedOption { Option: "Park" } => HandTarget.OfMachine(context.Machine.Profile.Park ?? throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.NoParkPosition")), scale),
            _ => await OfDrawingAsync(context, context.Document.Current.Settings.Start, cancellation).ConfigureAwait(false),
        };
        await ManualMotion.MoveToAsync(context, goal, cancellation).ConfigureAwait(false);
    }

    /// <summary>Raises the tool axis to the clearance height above the work; X and Y do not move.</summary>
    /// <exception cref="CommandException">The machine has no tool axis, or the work origin is unknown.</exception>
    private static async Task ClearAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Profile.Height is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.NoClearance"));
        var zero = await ZeroAsync(context, cancellation).ConfigureAwait(false);
        await ManualMotion.ToClearanceAsync(context, zero, cancellation).ConfigureAwait(false);
    }

    /// <summary>A point of the drawing in machine counts by the active work origin; null outside the counter range.</summary>
    /// <exception cref="CommandException">The work origin is unknown.</exception>
    private static async Task<CountsPoint?> OfDrawingAsync(CommandContext context, Point2D drawing, CancellationToken cancellation) =>
        HandTarget.OfDrawing(drawing, await ZeroAsync(context, cancellation).ConfigureAwait(false), context.Machine.Profile.Scale);

    /// <summary>The drawing's zero by the active work origin, counts; queries the controller whether its zero is unchanged since the origin was set.</summary>
    /// <exception cref="CommandException">The origin is not set, or the controller's zero is lost.</exception>
    private static async Task<CountsPoint> ZeroAsync(CommandContext context, CancellationToken cancellation)
    {
        var memory = context.Machine.Connection.Lease!.Memory;
        if (memory.ActiveOrigin?.Plane is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.WorkOriginNotSet", memory.Active));
        var found = await context.Machine.Origins.FindZeroAsync(cancellation).ConfigureAwait(false);
        return found?.Frame ?? throw new CommandException(CommandFailure.Refused, found?.Refusal is { } refused ? SettingWording.AtCommandLine(refused).Message : Wording.Get("CncGoTo.WorkOriginNotSet", memory.Active));
    }
}
