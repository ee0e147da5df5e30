using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Machine;

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
            context.WriteMessage(name == memory.Active ? Wording.Get("CncOrigin.Active", sentence) : sentence, MessageKind.Result);
        }
    }

    /// <exception cref="CommandException">A job is running, the position exceeds the counter range, or the controller's zero is unknown.</exception>
    private static async Task TypeAsync(CommandContext context, StoredMachineState before, CancellationToken cancellation)
    {
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("CncOrigin.JobRuns"));
        var axes = context.Machine.Profile.Axes;
        var place = await context.ValueAsync(new MachinePositionPrompt(Wording.Get("CncOrigin.SpecifyPosition", before.Active)) { AllowsZ = axes.Z is not null }).ConfigureAwait(false);
        if (!place.FitsCounter(axes.Scale)) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.PositionOutOfRange"));
        if (before.ActiveOrigin is { IsAssumed: false } && !await context.ConfirmAsync(Wording.Get("CncZero.ConfirmReplace", before.Active)).ConfigureAwait(false)) return;
        var part = context.Machine.Runs.Part;
        if (await context.Machine.Origins.TypeAsync(before.Active, place.ToCounts(axes.Scale), withHeight: place.Z is not null, cancellation).ConfigureAwait(false) is { } refusal) throw new CommandException(CommandFailure.Refused, SettingWording.AtCommandLine(refusal).Message);
        OriginText.WarnResumeDropped(context, part);
    }

    private static Task ChooseAsync(CommandContext context, string name)
    {
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("CncOrigin.JobRuns"));
        var part = context.Machine.Runs.Part;
        var failure = context.Machine.Origins.Choose(name);
        OriginText.WarnResumeDropped(context, part);
        return failure is not null ? throw new CommandException(CommandFailure.Refused, Wording.Get("CncOrigin.NotSaved", failure)) : Task.CompletedTask;
    }
}
