using Avalonia;
using Avalonia.Markup.Xaml;
using Avalonia.Styling;
using Engraver.App.Desk;
using Engraver.App.Safety;
using Engraver.App.Shell;
using Engraver.Workbench.Views;

namespace Engraver.App;

/// <summary>The operator desktop.</summary>
public partial class App : Application
{
    public override void Initialize() => AvaloniaXamlLoader.Load(this);

    /// <summary>The window on a desk; the theme follows the desk's view.</summary>
    public ShellWindow OpenShell(WorkDesk desk, StopKeys stopKeys)
    {
        ArgumentNullException.ThrowIfNull(desk);
        Follow();
        desk.Changed += Follow;
        return new ShellWindow(desk, stopKeys);

        void Follow() => RequestedThemeVariant = desk.Session.View.Current.Theme == DesktopTheme.Light ? ThemeVariant.Light : ThemeVariant.Dark;
    }
}
