namespace Engraver.Workbench.Views;

public enum DesktopTheme
{
    Dark,
    Light,
}
