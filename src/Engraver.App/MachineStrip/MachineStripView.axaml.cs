using Avalonia;
using Avalonia.Controls;

namespace Engraver.App.MachineStrip;

/// <summary>The grey strip under the menus. STOP acts when it is pressed, not when it is let go.</summary>
public partial class MachineStripView : UserControl
{
    /// <summary>In a narrower window inputs and outputs make room for the progress; CNCSTATUS shows them. Units of 1/96 inch.</summary>
    private const double LeastWidthForWires = 1270.0;

    /// <summary>In a still narrower one the state stands over the place, and the tool over the progress.</summary>
    private const double LeastWidthForOneRow = 1140.0;

    /// <summary>Below this nothing but what an operator must see has room.</summary>
    private const double LeastWidthForSegments = 1000.0;

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
        Classes.Set("tight", width < LeastWidthForSegments);
    }
}
