using Avalonia;
using Avalonia.Controls;

namespace Engraver.App.MachineStrip;

/// <summary>The grey strip under the menus. STOP acts on the press, not on the release.</summary>
public partial class MachineStripView : UserControl
{
    /// <summary>In a narrower window inputs and outputs are hidden in favour of the progress; CNCSTATUS shows them. Units of 1/96 inch.</summary>
    private const double MinWidthForInputsOutputs = 1270.0;

    /// <summary>In a still narrower window the state is above the position, and the tool above the progress.</summary>
    private const double MinWidthForOneRow = 1140.0;

    /// <summary>In a narrower window only what the operator must see is shown.</summary>
    private const double MinWidthForSegments = 1000.0;

    public MachineStripView()
    {
        InitializeComponent();
        SizeChanged += (_, e) => Arrange(e.NewSize.Width);
    }

    /// <summary>The area of STOP in its window, for presses that are handled without the UI thread.</summary>
    public Rect StopAreaIn(Visual window) => StopKey.TransformToVisual(window) is { } matrix ? new Rect(StopKey.Bounds.Size).TransformToAABB(matrix) : default;

    private void Arrange(double width)
    {
        WiresField.IsVisible = width >= MinWidthForInputsOutputs;
        Classes.Set("narrow", width < MinWidthForOneRow);
        Classes.Set("tight", width < MinWidthForSegments);
    }
}
