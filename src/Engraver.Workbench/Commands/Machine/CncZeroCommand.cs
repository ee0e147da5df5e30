using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCZERO: Sets the active work origin so that the current machine position is the drawing's zero or a typed point; with Height the tool is at a
/// typed height of the drawing, such as the thickness of a feeler gauge.</summary>
internal sealed class CncZeroCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_axes = Keyword.List("All", "X", "Y", "Z", "Point", "Height", "Edges", "Centre");

    public CommandInfo Info { get; } = new("CNCZERO", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Lease is not { Memory: var before }) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("CncOrigin.JobRuns"));
        var axes = await context.ChoiceAsync(Wording.Get("CncZero.EnterAxes", before.Active), s_axes, "All").ConfigureAwait(false);
        if (axes is "Edges" or "Centre")
        {
            await (axes == "Edges" ? TouchedZero.ByEdgeAsync(context, cancellation) : TouchedZero.ByCentreAsync(context, cancellation)).ConfigureAwait(false);
            return;
        }

        if (axes is "Z" or "Height" && context.Machine.Profile.Axes.Z is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncZero.NoZAxis"));
        var place = axes == "Point" ? await context.ValueAsync(new PointPrompt(Wording.Get("CncZero.SpecifyPoint"))).ConfigureAwait(false) : default;
        var height = axes == "Height" ? await context.ValueAsync(new NumberPrompt(Wording.Get("CncZero.SpecifyHeight"))).ConfigureAwait(false) : 0.0;
        if (IsSet(before, axes) && !await context.ConfirmAsync(Wording.Get("CncZero.ConfirmReplace", before.Active)).ConfigureAwait(false)) return;
        var touch = new ZeroTouch { X = axes is not ("Y" or "Z" or "Height"), Y = axes is not ("X" or "Z" or "Height"), Z = axes is "Z" or "Height" or "All", Place = place, Height = height };
        if (!touch.IsCountable(context.Machine.Profile.Scale)) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.PositionOutOfRange"));
        var part = context.Machine.Runs.Part;
        await OriginText.SetAsync(context, touch, cancellation).ConfigureAwait(false);
        OriginText.TellPart(context, part);
    }

    /// <summary>True if the operator has set the origin of one of these axes: the command asks before it is overwritten.</summary>
    private static bool IsSet(MachineMemory memory, string axes) => memory.ActiveOrigin is { IsAssumed: false } origin &&
        ((axes is not ("Y" or "Z" or "Height") && origin.X is not null) || (axes is not ("X" or "Z" or "Height") && origin.Y is not null) || (axes is "Z" or "Height" or "All" && origin.Z is not null));
}

/// <summary>CNCORIGIN: Chooses the work origin that jobs use, G54 to G59, sets the active one to a typed machine position, and lists all.</summary>
internal sealed class CncOriginCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_names = Keyword.List([.. WorkOriginNames.All, "Typed", "List"]);

    public CommandInfo Info { get; } = new("CNCORIGIN", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Lease is not { Memory: var before }) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        var chosen = await context.ChoiceAsync(Wording.Get("CncOrigin.Enter"), s_names, before.Active).ConfigureAwait(false);
        if (chosen == "Typed") await TypeAsync(context, before, cancellation).ConfigureAwait(false);
        else if (chosen != "List" && chosen != before.Active) await ChooseAsync(context, chosen).ConfigureAwait(false);
        var memory = context.Machine.Connection.Lease!.Memory;
        foreach (var name in chosen == "List" ? WorkOriginNames.All : [memory.Active])
        {
            var sentence = OriginText.Sentence(name, memory.Origins.GetValueOrDefault(name), context.Machine.Profile);
            context.Say(name == memory.Active ? Wording.Get("CncOrigin.Active", sentence) : sentence, MessageKind.Result);
        }
    }

    /// <exception cref="CommandException">A job is running, the position exceeds the counter range, or the controller's zero is unknown.</exception>
    private static async Task TypeAsync(CommandContext context, MachineMemory before, CancellationToken cancellation)
    {
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("CncOrigin.JobRuns"));
        var axes = context.Machine.Profile.Axes;
        var place = await context.ValueAsync(new MachinePlacePrompt(Wording.Get("CncOrigin.SpecifyPosition", before.Active)) { MayHaveHeight = axes.Z is not null }).ConfigureAwait(false);
        if (!place.IsCountable(axes.Scale)) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.PositionOutOfRange"));
        if (before.ActiveOrigin is { IsAssumed: false } && !await context.ConfirmAsync(Wording.Get("CncZero.ConfirmReplace", before.Active)).ConfigureAwait(false)) return;
        var part = context.Machine.Runs.Part;
        if (await context.Machine.Origins.TypeAsync(before.Active, place.ToCounts(axes.Scale), withHeight: place.Z is not null, cancellation).ConfigureAwait(false) is { } refusal) throw new CommandException(CommandFailure.Refused, SettingWording.AtCommandLine(refusal).Message);
        OriginText.TellPart(context, part);
    }

    private static Task ChooseAsync(CommandContext context, string name)
    {
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("CncOrigin.JobRuns"));
        var part = context.Machine.Runs.Part;
        var failure = context.Machine.Origins.Choose(name);
        OriginText.TellPart(context, part);
        return failure is not null ? throw new CommandException(CommandFailure.Refused, Wording.Get("CncOrigin.NotSaved", failure)) : Task.CompletedTask;
    }
}

/// <summary>Text of work origins for display.</summary>
internal static class OriginText
{
    /// <param name="origin">Null if it was never set.</param>
    public static string Sentence(string name, WorkOrigin? origin, MachineProfile profile)
    {
        if (origin is null) return Wording.Get("Origins.NotSet", name);
        string[] axes = [.. origin.ToMillimetres(profile).Select(axis => axis is { } set ? Wording.Get("Origins.Millimetres", set) : Wording.Get("Origins.AxisNotSet"))];
        var place = axes.Length == 2 ? Wording.Get("Origins.Place", axes[0], axes[1]) : Wording.Get("Origins.PlaceWithZ", axes[0], axes[1], axes[2]);
        return Wording.Get(origin.IsAssumed ? "Origins.Assumed" : "Origins.IsSet", name, place);
    }

    /// <summary>Sets the active origin at the current machine position and reports it.</summary>
    /// <exception cref="CommandException">The machine position is uncertain.</exception>
    public static async Task SetAsync(CommandContext context, ZeroTouch touch, CancellationToken cancellation)
    {
        var machine = context.Machine;
        if (await machine.Origins.SetAsync((memory, here) => touch.Set(memory, memory.Active, here.Position, machine.Profile), cancellation).ConfigureAwait(false) is { } refusal) throw new CommandException(CommandFailure.Refused, SettingWording.AtCommandLine(refusal).Message);
        var memory = machine.Connection.Lease!.Memory;
        context.Say(Sentence(memory.Active, memory.ActiveOrigin, machine.Profile), MessageKind.Result);
    }

    /// <summary>Warns that START now cuts the whole drawing, because the change of the origin discarded the selected part.</summary>
    /// <param name="before">The part that was selected before.</param>
    public static void TellPart(CommandContext context, JobPart? before)
    {
        if (before is not null && context.Machine.Runs.Part is null) context.Say(Wording.Get("Origins.ResumeDropped"), MessageKind.Warning);
    }
}
