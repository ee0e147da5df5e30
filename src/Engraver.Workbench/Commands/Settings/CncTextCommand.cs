using Engraver.Core.Drawings;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>CNCTEXT: Chooses whether the texts of the open drawing are engraved. The choice ends with the drawing.</summary>
internal sealed class CncTextCommand : ISettingCommand
{
    public CommandInfo Info { get; } = new("CNCTEXT", CommandGroup.Drawing);

    public string ValueText(CommandContext context) => new Keyword(IsOn(context) ? "Yes" : "No").Shown;

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var answer = await context.ChoiceAsync(Wording.Get("CncText.Question"), Keyword.List("Yes", "No"), IsOn(context) ? "Yes" : "No").ConfigureAwait(false);
        var (state, engraves) = (context.Document.Current, answer == "Yes");
        if (engraves == IsOn(context)) return;
        var cut = engraves ? state.Settings.Cut | CutChoice.Text : state.Settings.Cut & ~CutChoice.Text;
        context.Commit(state with { Settings = state.Settings with { Cut = cut }, CutsTexts = engraves });
    }

    private static bool IsOn(CommandContext context) => context.Document.Current.Settings.Cut.HasFlag(CutChoice.Text);
}
