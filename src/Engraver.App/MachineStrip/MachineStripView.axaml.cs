using Avalonia;
using Avalonia.Controls;

namespace Engraver.App.MachineStrip;

/// <summary>The grey strip under the menus. STOP acts when it is pressed, not when it is let go.</summary>
public partial class MachineStripView : UserControl
{
    public MachineStripView() => InitializeComponent();

    /// <summary>Where STOP stands in its window, for the path that does not wait for the UI thread.</summary>
    public Rect StopAreaIn(Visual window) => StopKey.TransformToVisual(window) is { } matrix ? new Rect(StopKey.Bounds.Size).TransformToAABB(matrix) : default;
}
