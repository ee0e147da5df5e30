using Avalonia.Controls;

namespace Engraver.App.Playback;

/// <summary>The bar under the canvas: the planned path in time.</summary>
public partial class PlaybackBar : UserControl
{
    public PlaybackBar() => InitializeComponent();
}
