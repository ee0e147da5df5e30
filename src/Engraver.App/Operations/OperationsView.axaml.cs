using Avalonia.Controls;

namespace Engraver.App.Operations;

/// <summary>The palette of operations.</summary>
public partial class OperationsView : UserControl
{
    public OperationsView() => InitializeComponent();
}
