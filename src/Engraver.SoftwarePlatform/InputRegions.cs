using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;

namespace Engraver.SoftwarePlatform;

/// <summary>The rectangles that handle a press on the input thread: an on-screen stop works while the user interface is busy, covered by a menu or behind a
/// dialog.</summary>
/// <remarks>Thread-safe. The newest region has precedence.</remarks>
public sealed class InputRegions
{
    private readonly Lock _gate = new();
    private readonly List<InputRegion> _regions = [];

    /// <param name="window">A window that has been opened.</param>
    /// <param name="area">In device independent units of the window.</param>
    /// <param name="pressed">Called on the input thread when the left button goes down inside; true swallows the press and the release that follows.</param>
    public InputRegion Add(TopLevel window, Rect area, Func<bool> pressed)
    {
        ArgumentNullException.ThrowIfNull(window);
        var handle = window.TryGetPlatformHandle() ?? throw new ArgumentException("The window has no platform window.", nameof(window));
        return Add(handle.Handle, area, MouseButton.Left, pressed);
    }

    public InputRegion Add(nint window, Rect area, MouseButton button, Func<bool> pressed)
    {
        ArgumentNullException.ThrowIfNull(pressed);
        var region = new InputRegion(this, window, area, button, pressed);
        lock (_gate) _regions.Add(region);
        return region;
    }

    internal void Remove(InputRegion region)
    {
        lock (_gate) _regions.Remove(region);
    }

    /// <summary>True if a region handled the press.</summary>
    internal bool Press(nint window, Point at, MouseButton button)
    {
        InputRegion? hit;
        lock (_gate) hit = _regions.FindLast(region => region.Contains(window, at, button));
        return hit is not null && hit.Press();
    }
}
