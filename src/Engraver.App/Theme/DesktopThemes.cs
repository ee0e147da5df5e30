using Avalonia.Styling;
using Engraver.Workbench.Settings;

namespace Engraver.App.Theme;

/// <summary>The themes of the desktop as theme variants of Avalonia. Their colours are in Colours.axaml.</summary>
public static class DesktopThemes
{
    /// <summary>White on black, every text at least 7 to 1 (WCAG 2, AAA); Avalonia's own parts are as in the dark theme.</summary>
    public static ThemeVariant HighContrast { get; } = new(nameof(DesktopTheme.HighContrast), ThemeVariant.Dark);

    public static ThemeVariant Of(DesktopTheme theme) => theme switch
    {
        DesktopTheme.Light => ThemeVariant.Light,
        DesktopTheme.HighContrast => HighContrast,
        _ => ThemeVariant.Dark,
    };
}
