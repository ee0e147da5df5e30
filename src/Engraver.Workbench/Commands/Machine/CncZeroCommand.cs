using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCZERO: The place where the machine stands becomes a place of the drawing, in the active work origin: its zero, or what is typed.</summary>
internal sealed class CncZeroCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_axes = Keyword.List("All", "X", "Y", "Point");

    public CommandInfo Info { get; } = new("CNCZERO", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Hold is not { Memory: var before }) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NoControllerConnectedCncconnect"));
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("CncOrigin.JobRuns"));
        var axes = await context.ChoiceAsync(Wording.Get("CncZero.WhichAxes", before.Active), s_axes, "All").ConfigureAwait(false);
        var place = axes == "Point" ? await context.ValueAsync(new PointPrompt(Wording.Get("CncZero.SpecifyPlace"))).ConfigureAwait(false) : default;
        if (IsSet(before, axes) && !await context.ConfirmAsync(Wording.Get("CncZero.IsSetAlready", before.Active)).ConfigureAwait(false)) return;
        var at = context.Machine.Profile.Scale.ToCounts(place);
        var memory = await context.Machine.SetOriginAsync(
            (memory, here) => memory.WithOrigin(memory.Active, axes == "Y" ? null : here.Position.X - at.X, axes == "X" ? null : here.Position.Y - at.Y, null), cancellation).ConfigureAwait(false);
        context.Say(OriginText.Sentence(memory.Active, memory.ActiveOrigin, context.Machine.Profile), MessageKind.Result);
    }

    /// <summary>Only what somebody set is asked about before it is lost.</summary>
    private static bool IsSet(MachineMemory memory, string axes) => memory.ActiveOrigin is { IsAssumed: false } origin && ((axes != "Y" && origin.X is not null) || (axes != "X" && origin.Y is not null));
}

/// <summary>CNCORIGIN: Chooses the work origin that jobs use, G54 to G59, and lists where they lie.</summary>
internal sealed class CncOriginCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_names = Keyword.List([.. WorkOriginNames.All, "List"]);

    public CommandInfo Info { get; } = new("CNCORIGIN", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Hold is not { Memory: var before }) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NoControllerConnectedCncconnect"));
        var chosen = await context.ChoiceAsync(Wording.Get("CncOrigin.Enter"), s_names, before.Active).ConfigureAwait(false);
        if (chosen != "List" && chosen != before.Active) await ChooseAsync(context, chosen).ConfigureAwait(false);
        var memory = context.Machine.Hold!.Memory;
        foreach (var name in chosen == "List" ? WorkOriginNames.All : [memory.Active])
            context.Say(OriginText.Sentence(name, memory.Origins.GetValueOrDefault(name), context.Machine.Profile) + (name == memory.Active ? Wording.Get("CncOrigin.IsActive") : ""), MessageKind.Result);
    }

    private static Task ChooseAsync(CommandContext context, string name)
    {
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("CncOrigin.JobRuns"));
        return context.Machine.ChooseOrigin(name) is { } failure ? throw new CommandException(CommandFailure.Refused, Wording.Get("CncOrigin.NotKept", failure)) : Task.CompletedTask;
    }
}

/// <summary>Work origins in words.</summary>
internal static class OriginText
{
    /// <param name="origin">Null for one that was never set.</param>
    public static string Sentence(string name, WorkOrigin? origin, MachineProfile profile)
    {
        if (origin is null) return Wording.Get("Origins.NotSet", name);
        var (x, y) = (Axis(origin.X, profile.Scale.X), Axis(origin.Y, profile.Scale.Y));
        return Wording.Get(origin.IsAssumed ? "Origins.LiesAssumed" : "Origins.Lies", name, x, y);
    }

    private static string Axis(int? counts, double countsPerMillimetre) => counts is { } set ? Wording.Get("Origins.Millimetres", set / countsPerMillimetre) : Wording.Get("Origins.AxisNotSet");
}
