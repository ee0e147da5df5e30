using Avalonia;
using Avalonia.Styling;
using Avalonia.Themes.Fluent;

namespace Engraver.SoftwarePlatform.Tests;

/// <summary>The smallest application with a real theme.</summary>
internal sealed class DemoApp : Application
{
    public override void Initialize()
    {
        Styles.Add(new FluentTheme());
        RequestedThemeVariant = ThemeVariant.Dark;
    }
}
