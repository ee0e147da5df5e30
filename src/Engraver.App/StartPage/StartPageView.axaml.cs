using Avalonia.Controls;

namespace Engraver.App.StartPage;

/// <summary>The page on the canvas while no drawing is open. Clicks beside its entries go to the canvas.</summary>
public partial class StartPageView : UserControl
{
    public StartPageView() => InitializeComponent();
}
