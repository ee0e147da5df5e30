using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCGOTO: Moves the machine at rapid speed with the tool off: to a machine position, a place of the drawing, the drawing's start point or the
/// park position. A tool that an axis holds is raised to its clearance height over the work first; Clearance does that alone.</summary>
internal sealed class CncGoToCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("Work", "Start", "Park", "Clearance");

    public CommandInfo Info { get; } = new("CNCGOTO", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        HandMotion.Check(context);
        var answer = await context.AskAsync(new MachinePlacePrompt(Wording.Get("CncGoTo.SpecifyMachinePosition")) { Options = s_options }).ConfigureAwait(false);
        if (answer is Answer<MachinePlace>.Chosen { Option: "Clearance" })
        {
            await ClearAsync(context, cancellation).ConfigureAwait(false);
            return;
        }

        var scale = context.Machine.Profile.Scale;
        var goal = answer switch
        {
            Answer<MachinePlace>.Value { Of: var place } => HandPlace.OfMachine(new Point2D(place.X, place.Y), scale),
            Answer<MachinePlace>.Chosen { Option: "Work" } => await OfDrawingAsync(context, await context.ValueAsync(new PointPrompt(Wording.Get("CncGoTo.SpecifyDrawingPoint"))).ConfigureAwait(false), cancellation).ConfigureAwait(false),
            Answer<MachinePlace>.Chosen { Option: "Park" } => HandPlace.OfMachine(context.Machine.Profile.Park ?? throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.NoParkPosition")), scale),
            _ => await OfDrawingAsync(context, context.Document.Current.Settings.Start, cancellation).ConfigureAwait(false),
        };
        await HandMotion.GoAsync(context, goal, cancellation).ConfigureAwait(false);
    }

    /// <summary>Brings a tool that an axis holds to its clearance height over the work; the machine stays where it is in plan.</summary>
    /// <exception cref="CommandException">No axis holds the tool, or nobody knows where the work is.</exception>
    private static async Task ClearAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Profile.Height is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.NoClearance"));
        var zero = await ZeroAsync(context, cancellation).ConfigureAwait(false);
        await HandMotion.ToClearanceAsync(context, zero, cancellation).ConfigureAwait(false);
    }

    /// <summary>A place of the drawing through the active work origin; null where the controller cannot count it.</summary>
    /// <exception cref="CommandException">Nobody knows where the work is.</exception>
    private static async Task<CountsPoint?> OfDrawingAsync(CommandContext context, Point2D drawing, CancellationToken cancellation) =>
        HandPlace.OfDrawing(drawing, await ZeroAsync(context, cancellation).ConfigureAwait(false), context.Machine.Profile.Scale);

    /// <summary>The drawing's zero by the active work origin, counts; the controller is asked whether it still counts from where the origin was set.</summary>
    /// <exception cref="CommandException">The origin is not set, or its zero is lost.</exception>
    private static async Task<CountsPoint> ZeroAsync(CommandContext context, CancellationToken cancellation)
    {
        var memory = context.Machine.Connection.Lease!.Memory;
        if (memory.ActiveOrigin?.Plane is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.WorkOriginNotSet", memory.Active));
        var found = await context.Machine.Origins.FindZeroAsync(cancellation).ConfigureAwait(false);
        return found?.Frame ?? throw new CommandException(CommandFailure.Refused, found?.Refusal is { } refused ? SettingWording.AtCommandLine(refused).Message : Wording.Get("CncGoTo.WorkOriginNotSet", memory.Active));
    }
}
