using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCZERO: The place where the machine stands becomes a place of the drawing, in the active work origin: its zero, or what is typed.</summary>
internal sealed class CncZeroCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_axes = Keyword.List("All", "X", "Y", "Point");

    public CommandInfo Info { get; } = new("CNCZERO", CommandGroup.Machine, "The place where the machine stands becomes the drawing's zero in X, in Y or in both, or the place of the drawing that is typed; kept with the machine as its active work origin.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Hold is not { Memory: var before }) throw new CommandException(CommandFailure.Usage, "No controller is connected; CNCCONNECT first.");
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, "A job runs; the origin cannot change under it.");
        var axes = await context.ChoiceAsync($"Set {before.Active} where the machine stands: which axes?", s_axes, "All").ConfigureAwait(false);
        var place = axes == "Point" ? await context.ValueAsync(new PointPrompt("Specify the place of the drawing at which the machine stands")).ConfigureAwait(false) : default;
        if (IsSet(before, axes) && !await context.ConfirmAsync($"{before.Active} is set already. Set it anew?").ConfigureAwait(false)) return;
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

    public CommandInfo Info { get; } = new("CNCORIGIN", CommandGroup.Machine, "Chooses the work origin that jobs use, G54 to G59, and lists where they lie.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Hold is not { Memory: var before }) throw new CommandException(CommandFailure.Usage, "No controller is connected; CNCCONNECT first.");
        var chosen = await context.ChoiceAsync("Enter work origin", s_names, before.Active).ConfigureAwait(false);
        if (chosen != "List" && chosen != before.Active) await ChooseAsync(context, chosen).ConfigureAwait(false);
        var memory = context.Machine.Hold!.Memory;
        foreach (var name in chosen == "List" ? WorkOriginNames.All : [memory.Active])
            context.Say(OriginText.Sentence(name, memory.Origins.GetValueOrDefault(name), context.Machine.Profile) + (name == memory.Active ? " It is the active one." : ""), MessageKind.Result);
    }

    private static Task ChooseAsync(CommandContext context, string name)
    {
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, "A job runs; the origin cannot change under it.");
        return context.Machine.ChooseOrigin(name) is { } failure ? throw new CommandException(CommandFailure.Refused, $"The origin could not be written down: {failure}.") : Task.CompletedTask;
    }
}

/// <summary>Work origins in words.</summary>
internal static class OriginText
{
    /// <param name="origin">Null for one that was never set.</param>
    public static string Sentence(string name, WorkOrigin? origin, MachineProfile profile)
    {
        if (origin is null) return $"{name} is not set.";
        var (x, y) = (Axis(origin.X, profile.CountsPerMillimetreX), Axis(origin.Y, profile.CountsPerMillimetreY));
        return $"{name}: the drawing's zero lies at X {x}, Y {y} of the machine{(origin.IsAssumed ? ", where the controller counted 0; nobody set it" : "")}.";
    }

    private static string Axis(int? counts, double countsPerMillimetre) => counts is { } set ? string.Create(CultureInfo.InvariantCulture, $"{set / countsPerMillimetre:0.###} mm") : "(not set)";
}
