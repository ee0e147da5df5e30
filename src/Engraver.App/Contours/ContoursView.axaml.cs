using Avalonia.Controls;

namespace Engraver.App.Contours;

/// <summary>The palette of contours in cutting order.</summary>
public partial class ContoursView : UserControl
{
    public ContoursView() => InitializeComponent();
}
