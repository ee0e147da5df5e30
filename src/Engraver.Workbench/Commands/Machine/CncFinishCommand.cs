using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCFINISH: Chooses where the machine goes after the last stroke, tool off: to the drawing's start point, nowhere, or to the park position of
/// profile.</summary>
internal sealed class CncFinishCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCFINISH", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var settings = context.Document.Current.Settings;
        var chosen = SettingTable.Finish.ParseInput(await context.ChoiceAsync(Wording.Get("CncFinish.EnterPosition"), Keyword.List([.. SettingTable.Finish.Choices]), SettingTable.Finish.ToInput(settings)).ConfigureAwait(false));
        if (chosen == FinishPlace.Park && settings.Machine.Park is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncFinish.NoParkPosition"));
        context.Commit(context.Document.Current with { Settings = settings with { Finish = chosen } });
    }
}
