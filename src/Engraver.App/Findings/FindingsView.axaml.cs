using Avalonia.Controls;

namespace Engraver.App.Findings;

/// <summary>The page of the findings of CHECK.</summary>
public partial class FindingsView : UserControl
{
    public FindingsView() => InitializeComponent();
}
