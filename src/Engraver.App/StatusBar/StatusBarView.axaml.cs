using Avalonia.Controls;

namespace Engraver.App.StatusBar;

/// <summary>The line at the bottom of the shell.</summary>
public partial class StatusBarView : UserControl
{
    public StatusBarView() => InitializeComponent();
}
