using Avalonia.Controls;

namespace Engraver.App.Plots;

/// <summary>The palette of plots.</summary>
public partial class PlotView : UserControl
{
    public PlotView() => InitializeComponent();
}
