using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.View;

/// <summary>THEME: Chooses the dark, the light or the high-contrast desktop.</summary>
internal sealed class ThemeCommand : ICommand
{
    public CommandInfo Info { get; } = new("THEME", CommandGroup.View) { IsTransparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var now = context.View.Current.Theme.ToString();
        var theme = Enum.Parse<DesktopTheme>(await context.ChoiceAsync(Wording.Get("Theme.EnterTheme"), Keyword.List([.. Enum.GetNames<DesktopTheme>()]), now).ConfigureAwait(false));
        context.View.Change(view => view with { Theme = theme });
        context.Settings.Change(settings => settings with { Theme = theme });
    }
}
