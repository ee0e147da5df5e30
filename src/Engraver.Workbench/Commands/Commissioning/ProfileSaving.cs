using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>The end of a commissioning: writes and uses the profile and burns the controller's settings, each if the operator agrees.</summary>
internal static class ProfileSaving
{
    private static readonly IReadOnlyList<Keyword> s_answers = Keyword.List("Yes", "No");

    public static async Task RunAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        var context = machine.Context;
        foreach (var (name, axis) in machine.Profile.Axes.Named) context.WriteMessage(Wording.Get("Commission.ProfileAxis", name, axis.Letter, axis.CountsPerMillimetre), MessageKind.Result);
        context.WriteMessage(Wording.Get("Commission.ProfileOutput", machine.Profile.ToolOutput), MessageKind.Result);
        if (await context.ChoiceAsync(Wording.Get("Commission.ConfirmWriteProfile"), s_answers, null).ConfigureAwait(false) == "Yes") await WriteAsync(machine).ConfigureAwait(false);
        else context.WriteMessage(Wording.Get("Commission.NothingWritten"));
        if (machine.HasAccepted) await BurnAsync(context, cancellation).ConfigureAwait(false);
    }

    private static async Task WriteAsync(CommissionedMachine machine)
    {
        var context = machine.Context;
        while (true)
        {
            var name = await context.ValueAsync(new TextPrompt(Wording.Get("Commission.EnterFileName")) { Default = context.CommissionedProfile }).ConfigureAwait(false);
            var path = context.ResolveOutputPath(name);
            if (File.Exists(path) && !await context.ConfirmAsync(Wording.Get("ResultFile.ReplaceExisting", name)).ConfigureAwait(false)) continue;
            if (!TryWrite(context, path, name, machine.Profile)) continue;
            context.WriteMessage(Wording.Get("Commission.Written", name, context.ApplyTerminology("[machine]")), MessageKind.Result);
            if (machine.Profile.Axes.X.Letter != machine.Start.Axes.X.Letter) context.WriteMessage(context.ApplyTerminology(Wording.Get("Commission.SetOriginsAgain")), MessageKind.Warning);
            context.Settings.Change(settings => settings with { LastProfile = Path.GetFullPath(path) });
            var state = context.Document.Current;
            context.Commit(state with { Settings = state.Settings with { Machine = machine.Profile } });
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
            context.WriteMessage(Wording.Get("Commission.NotWritten", name, SystemErrorText.FromException(failure)), MessageKind.Warning);
            return false;
        }
    }

    private static async Task BurnAsync(CommandContext context, CancellationToken cancellation)
    {
        if (!await context.ConfirmAsync(Wording.Get("Commission.ConfirmBurn")).ConfigureAwait(false))
        {
            context.WriteMessage(Wording.Get("Commission.NotBurned"), MessageKind.Warning);
            return;
        }

        var refused = await context.Machine.Setup.ApplyAsync(setup => setup.BurnAsync(cancellation), CancellationToken.None).ConfigureAwait(false);
        if (refused is not null) throw new CommandException(CommandFailure.Refused, refused);
        context.WriteMessage(Wording.Get("Commission.Burned"), MessageKind.Result);
    }
}
