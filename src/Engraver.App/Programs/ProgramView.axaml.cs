using Avalonia.Controls;

namespace Engraver.App.Programs;

/// <summary>The palette of the controller's program.</summary>
public partial class ProgramView : UserControl
{
    public ProgramView() => InitializeComponent();
}
