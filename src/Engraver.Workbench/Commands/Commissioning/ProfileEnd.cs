using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>The end of a commissioning: writes and uses the profile and burns the controller's settings, each if the operator agrees.</summary>
internal static class ProfileEnd
{
    private static readonly IReadOnlyList<Keyword> s_answers = Keyword.List("Yes", "No");

    public static async Task RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        var context = machine.Context;
        foreach (var (name, axis) in machine.Profile.Axes.Named) context.Say(Wording.Get("Commission.ProfileAxis", name, axis.Letter, axis.CountsPerMillimetre), MessageKind.Result);
        context.Say(Wording.Get("Commission.ProfileOutput", machine.Profile.ToolOutput), MessageKind.Result);
        if (await context.ChoiceAsync(Wording.Get("Commission.ConfirmWriteProfile"), s_answers, null).ConfigureAwait(false) == "Yes") await WriteAsync(machine).ConfigureAwait(false);
        else context.Say(Wording.Get("Commission.NothingWritten"));
        if (machine.HasAccepted) await BurnAsync(context, cancellation).ConfigureAwait(false);
    }

    private static async Task WriteAsync(CommissionedMachine machine)
    {
        var context = machine.Context;
        while (true)
        {
            var name = await context.ValueAsync(new TextPrompt(Wording.Get("Commission.EnterFileName")) { Default = context.CommissionedProfile }).ConfigureAwait(false);
            var path = context.FileToWrite(name);
            if (File.Exists(path) && !await context.ConfirmAsync(Wording.Get("ResultFile.ReplaceExisting", name)).ConfigureAwait(false)) continue;
            if (!TryWrite(context, path, name, machine.Profile)) continue;
            context.Say(Wording.Get("Commission.Written", name, context.Spell("[machine]")), MessageKind.Result);
            if (machine.Profile.Axes.X.Letter != machine.Start.Axes.X.Letter) context.Say(context.Spell(Wording.Get("Commission.SetOriginsAgain")), MessageKind.Warning);
            context.Settings.Change(settings => settings with { LastProfile = Path.GetFullPath(path) });
            var state = context.Document.Current;
            context.Take(state with { Settings = state.Settings with { Machine = machine.Profile } });
            return;
        }
    }

    /// <returns>False if the path cannot be written, which was reported; the answers are kept.</returns>
    private static bool TryWrite(CommandContext context, string path, string name, MachineProfile profile)
    {
        try
        {
            OutputFile.Write(path, output => output.Write(MachineProfileFile.Write(profile)));
            return true;
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            context.Say(Wording.Get("Commission.NotWritten", name, SystemReason.Of(failure)), MessageKind.Warning);
            return false;
        }
    }

    private static async Task BurnAsync(CommandContext context, CancellationToken cancellation)
    {
        if (!await context.ConfirmAsync(Wording.Get("Commission.ConfirmBurn")).ConfigureAwait(false))
        {
            context.Say(Wording.Get("Commission.NotBurned"), MessageKind.Warning);
            return;
        }

        var refused = await context.Machine.Setup.ApplyAsync(setup => setup.BurnAsync(cancellation), CancellationToken.None).ConfigureAwait(false);
        if (refused is not null) throw new CommandException(CommandFailure.Refused, refused);
        context.Say(Wording.Get("Commission.Burned"), MessageKind.Result);
    }
}
