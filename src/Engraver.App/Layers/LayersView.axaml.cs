using Avalonia.Controls;

namespace Engraver.App.Layers;

/// <summary>The palette of layers.</summary>
public partial class LayersView : UserControl
{
    public LayersView() => InitializeComponent();
}
