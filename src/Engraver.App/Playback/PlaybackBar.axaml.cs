using Avalonia.Controls;

namespace Engraver.App.Playback;

/// <summary>The bar under the canvas: the planned path in time.</summary>
public partial class PlaybackBar : UserControl
{
    /// <summary>In a narrower bar the speeds are hidden in favour of the time; PLAYBACK sets them. Units of 1/96 inch.</summary>
    private const double MinWidthForSpeeds = 470.0;

    public PlaybackBar()
    {
        InitializeComponent();
        SizeChanged += (_, e) => SpeedList.IsVisible = e.NewSize.Width >= MinWidthForSpeeds;
    }
}
