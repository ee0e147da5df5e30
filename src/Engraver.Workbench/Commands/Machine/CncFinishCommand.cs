using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCFINISH: Selects the target of the machine after the last stroke, tool off: the drawing's start point, none, or the park position of the machine
/// profile.</summary>
internal sealed class CncFinishCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCFINISH", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var settings = context.Document.Current.Settings;
        var chosen = Enum.Parse<FinishPlace>(await context.ChoiceAsync(Wording.Get("CncFinish.EnterPosition"), Keyword.List([.. Enum.GetNames<FinishPlace>()]), settings.Finish.ToString()).ConfigureAwait(false));
        if (chosen == FinishPlace.Park && settings.Machine.Park is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncFinish.NoParkPosition"));
        context.Take(context.Document.Current with { Settings = settings with { Finish = chosen } });
    }
}
