using Avalonia.Controls;

namespace Engraver.App.Contours;

/// <summary>The palette of contours in the order of cutting.</summary>
public partial class ContoursView : UserControl
{
    public ContoursView() => InitializeComponent();
}
