using Avalonia;
using Avalonia.Markup.Xaml;

namespace Engraver.App;

/// <summary>The operator desktop.</summary>
public partial class App : Application
{
    public override void Initialize() => AvaloniaXamlLoader.Load(this);
}
