using Avalonia;
using Avalonia.Controls;

namespace Engraver.App.Shell;

/// <summary>The initial size of a window: its last size, but at most the size of the screen.</summary>
internal static class OpeningSize
{
    /// <summary>Height of the title bar that the window manager adds, units of 1/96 inch.</summary>
    private const double TitleBar = 32;

    /// <param name="wanted">The last size, units of 1/96 inch.</param>
    public static void Apply(Window window, Size wanted)
    {
        var room = window.Screens.Primary is { } screen ? screen.WorkingArea.Size.ToSize(screen.Scaling) : wanted;
        var size = wanted.Constrain(new Size(room.Width, Math.Max(1, room.Height - TitleBar)));
        (window.MinWidth, window.MinHeight) = (Math.Min(window.MinWidth, size.Width), Math.Min(window.MinHeight, size.Height));
        (window.Width, window.Height) = (size.Width, size.Height);
    }
}
