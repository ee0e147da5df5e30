using Avalonia;
using Avalonia.Controls;

namespace Engraver.App.MachineStrip;

/// <summary>The grey strip under the menus. STOP acts when it is pressed, not when it is let go.</summary>
public partial class MachineStripView : UserControl
{
    /// <summary>In a narrower window inputs and outputs make room for the progress; CNCSTATUS shows them. Units of 1/96 inch.</summary>
    private const double LeastWidthForWires = 1270.0;

    /// <summary>In a still narrower one the strip has two rows.</summary>
    private const double LeastWidthForOneRow = 1140.0;

    public MachineStripView()
    {
        InitializeComponent();
        SizeChanged += (_, e) => Arrange(e.NewSize.Width);
    }

    /// <summary>The area of STOP in its window, for presses that are seen without the UI thread.</summary>
    public Rect StopAreaIn(Visual window) => StopKey.TransformToVisual(window) is { } matrix ? new Rect(StopKey.Bounds.Size).TransformToAABB(matrix) : default;

    private void Arrange(double width)
    {
        WiresField.IsVisible = width >= LeastWidthForWires;
        Classes.Set("narrow", width < LeastWidthForOneRow);
    }
}
