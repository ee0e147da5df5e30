using Avalonia.Controls;

namespace Engraver.App.Trajectories;

/// <summary>The table of trajectories.</summary>
public partial class TrajectoriesView : UserControl
{
    public TrajectoriesView() => InitializeComponent();
}
