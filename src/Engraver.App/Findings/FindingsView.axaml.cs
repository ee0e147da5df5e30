using Avalonia.Controls;

namespace Engraver.App.Findings;

/// <summary>The page of the drawing doctor's findings.</summary>
public partial class FindingsView : UserControl
{
    public FindingsView() => InitializeComponent();
}
