using Avalonia;
using Avalonia.Controls;

namespace Engraver.App.MachineStrip;

/// <summary>The grey strip under the menus. STOP acts when it is pressed, not when it is let go.</summary>
public partial class MachineStripView : UserControl
{
    /// <summary>In a narrower window inputs and outputs make room for the progress; CNCSTATUS shows them.</summary>
    private const double LeastWidthForWires = 1160.0;

    public MachineStripView()
    {
        InitializeComponent();
        SizeChanged += (_, e) => WiresField.IsVisible = e.NewSize.Width >= LeastWidthForWires;
    }

    /// <summary>The area of STOP in its window, for presses that are seen without the UI thread.</summary>
    public Rect StopAreaIn(Visual window) => StopKey.TransformToVisual(window) is { } matrix ? new Rect(StopKey.Bounds.Size).TransformToAABB(matrix) : default;
}
