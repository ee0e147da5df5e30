using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>PLOTCOMPARE: Selects a stored run that the plots show beside the plan and the last run.</summary>
internal sealed class PlotCompareCommand : ICommand
{
    public CommandInfo Info { get; } = new("PLOTCOMPARE", CommandGroup.Machine) { IsAllowedDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        switch (await context.ChoiceAsync(Wording.Get("PlotCompare.EnterOption"), Keyword.List("File", "LIst", "LAst", "Off"), "LAst").ConfigureAwait(false))
        {
            case "File":
                Compare(context, await StoredRun.AskAsync(context).ConfigureAwait(false));
                break;
            case "LIst":
                StoredRun.WriteList(context);
                break;
            case "LAst":
                Compare(context, StoredRun.LastOf(context));
                break;
            default:
                context.Plots.CompareNothing();
                context.WriteMessage(Wording.Get("PlotCompare.Removed"), MessageKind.Result);
                break;
        }
    }

    private static void Compare(CommandContext context, string journal)
    {
        context.Plots.Compare(journal, StoredRun.Read(context, journal));
        context.WriteMessage(Wording.Get("PlotCompare.Chosen", journal), MessageKind.Result);
    }
}
