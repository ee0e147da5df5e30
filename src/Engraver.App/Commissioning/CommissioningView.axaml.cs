using Avalonia.Controls;

namespace Engraver.App.Commissioning;

/// <summary>The page of commissioning.</summary>
public partial class CommissioningView : UserControl
{
    public CommissioningView() => InitializeComponent();
}
