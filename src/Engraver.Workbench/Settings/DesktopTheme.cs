namespace Engraver.Workbench.Settings;

public enum DesktopTheme
{
    Dark,
    Light,

    /// <summary>White on black.</summary>
    HighContrast,
}
