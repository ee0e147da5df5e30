using Avalonia;
using Avalonia.Input;

namespace Engraver.SoftwarePlatform;

/// <summary>A rectangle of one window that handles a press on the input thread. Disposing removes it.</summary>
public sealed class InputRegion : IDisposable
{
    private readonly InputRegions _owner;
    private readonly Func<bool> _pressed;
    private readonly Lock _gate = new();
    private Rect _area;

    internal InputRegion(InputRegions owner, nint window, Rect area, MouseButton button, Func<bool> pressed)
    {
        _owner = owner;
        Window = window;
        Button = button;
        _area = area;
        _pressed = pressed;
    }

    /// <summary>The platform handle of the window.</summary>
    public nint Window { get; }

    public MouseButton Button { get; }

    /// <summary>In device independent units of the window. May be set from any thread, as the layout moves.</summary>
    public Rect Area
    {
        get
        {
            lock (_gate) return _area;
        }
        set
        {
            lock (_gate) _area = value;
        }
    }

    public void Dispose() => _owner.Remove(this);

    internal bool Contains(nint window, Point at, MouseButton button) => window == Window && button == Button && Area.Contains(at);

    internal bool Press() => _pressed();
}
