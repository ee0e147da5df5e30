using Avalonia.Controls;
using Avalonia.Interactivity;
using Avalonia.VisualTree;
using Engraver.App.Tabs;

namespace Engraver.App.Plots;

/// <summary>The page of plots.</summary>
public partial class PlotsView : UserControl
{
    public PlotsView()
    {
        InitializeComponent();
        Plot.Sought += (_, place) => (DataContext as PlotsModel)?.Seek(place);
    }

    private void OnEnlarge(object? sender, RoutedEventArgs e) => this.FindAncestorOfType<PageTabs>()?.RequestWiden();

    private void OnFit(object? sender, RoutedEventArgs e) => Plot.Fit();
}
