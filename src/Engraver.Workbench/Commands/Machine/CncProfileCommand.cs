using Engraver.Core.Diagnostics;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCPROFILE: Loads a machine profile from a file.</summary>
internal sealed class CncProfileCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCPROFILE", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var name = await context.ValueAsync(new FilePrompt(Wording.Get("CncProfile.EnterName"), new FileRequest("profile", false, ".json"))).ConfigureAwait(false);
        var profile = MachineProfileSource.Load(context.ResolveInputPath(name), context.Families, finding => FindingMessages.Write(context, name, [finding], Severity.Warning));
        context.Settings.Change(settings => settings with { LastProfile = Path.GetFullPath(context.ResolveInputPath(name)) });
        var state = context.Document.Current;
        context.Commit(state with { Settings = state.Settings with { Machine = profile } });
    }
}
