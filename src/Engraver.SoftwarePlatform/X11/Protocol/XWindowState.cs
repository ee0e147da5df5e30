using Avalonia.Controls;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>Avalonia's window state from the window manager's list.</summary>
internal static class XWindowState
{
    public static WindowState FromList(ReadOnlySpan<nint> states, XAtoms atoms)
    {
        if (states.Contains(atoms.NetWmStateHidden)) return WindowState.Minimized;
        if (states.Contains(atoms.NetWmStateFullscreen)) return WindowState.FullScreen;
        var both = states.Contains(atoms.NetWmStateMaximizedHorizontally) && states.Contains(atoms.NetWmStateMaximizedVertically);
        return both ? WindowState.Maximized : WindowState.Normal;
    }
}
