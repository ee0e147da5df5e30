using Avalonia.Controls;

namespace Engraver.App.Commissioning;

/// <summary>The commissioning page.</summary>
public partial class CommissioningView : UserControl
{
    public CommissioningView() => InitializeComponent();
}
