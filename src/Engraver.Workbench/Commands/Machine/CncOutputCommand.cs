using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCOUTPUT: Switches an output manually, by its name in the profile or its number; asks first if this activates something.</summary>
internal sealed class CncOutputCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_states = Keyword.List("ON", "OFF");

    public CommandInfo Info { get; } = new("CNCOUTPUT", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        ManualMotion.ThrowIfNotReady(context);
        var profile = context.Machine.Profile;
        var typed = await context.ValueAsync(new TextPrompt(Wording.Get("CncOutput.EnterOutput"))).ConfigureAwait(false);
        var most = context.Driver.Limits.Outputs;
        var output = profile.Outputs.Find(typed, most) ?? throw new CommandException(CommandFailure.Usage, Wording.Get("CncOutput.NotAnOutput", typed, most, string.Join(", ", profile.Outputs.All.Values)));
        var on = await context.ChoiceAsync(Wording.Get("CncOutput.EnterState", profile.Outputs[output]), s_states, null).ConfigureAwait(false) == "ON";
        if (profile.IsForJobsOnly(output, on)) throw new CommandException(CommandFailure.Refused, Wording.Get(on ? "CncOutput.ToolOutput" : "CncOutput.ToolOutputActiveLow", output));
        var begins = profile.IsOnAt(output, on);
        if (begins && !await context.ConfirmAsync(Wording.Get(on ? "CncOutput.ConfirmOn" : "CncOutput.ConfirmOff", profile.Outputs[output])).ConfigureAwait(false)) return;
        if (await context.Machine.Hand.SetOutputAsync(output, on, cancellation).ConfigureAwait(false) is { } refused) throw new CommandException(CommandFailure.Refused, refused.Message);
        context.WriteMessage(StateText(profile.Outputs[output], on, begins), MessageKind.Result);
    }

    private static string StateText(string name, bool on, bool begins) => (on, begins) switch
    {
        (true, true) => Wording.Get("CncOutput.IsOn", name),
        (true, false) => Wording.Get("CncOutput.IsOnActiveLow", name),
        (false, true) => Wording.Get("CncOutput.IsOffActiveLow", name),
        (false, false) => Wording.Get("CncOutput.IsOff", name),
    };
}
