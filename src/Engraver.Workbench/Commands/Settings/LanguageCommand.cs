using Engraver.Core.Languages;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>LANGUAGE: Chooses the language of the desktop, from its next start: a window that shows two languages at once would be worse than one that
/// waits.</summary>
internal sealed class LanguageCommand : ICommand
{
    private const string Auto = "Auto";
    private const string English = "English";
    private const string EnglishCode = "en";

    public CommandInfo Info { get; } = new("LANGUAGE", CommandGroup.Setting) { IsTransparent = true };

    /// <summary>What may be chosen, in English.</summary>
    public static IReadOnlyList<string> Choices => [Auto, English, .. LanguageFile.All.Select(file => file.Name)];

    /// <summary>What is chosen now.</summary>
    public static string NameOf(DesktopSettings settings) => settings.Language is not { } code ? Auto : LanguageFile.All.FirstOrDefault(file => file.Code == code)?.Name ?? English;

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var now = context.Settings.Current.Language;
        var chosen = await context.ChoiceAsync(Wording.Get("Language.EnterLanguage"), Keyword.List([.. Choices]), NameOf(context.Settings.Current)).ConfigureAwait(false);
        var code = chosen == Auto ? null : LanguageFile.All.FirstOrDefault(file => file.Name == chosen)?.Code ?? EnglishCode;
        context.Settings.Change(settings => settings with { Language = code });
        if (code != now) context.WriteMessage(Wording.Get("Language.FromNextStart"));
    }
}
