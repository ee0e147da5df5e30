using Avalonia;
using Avalonia.Input;
using Avalonia.Logging;

namespace Engraver.SoftwarePlatform.Input;

/// <summary>Every key and button press passes through this on the input thread before it is queued for the user interface, in each front end.</summary>
/// <remarks>An exception in a filter is logged and the input passed on: the input thread must not end.</remarks>
internal sealed class InputGate(KeyFilter? filter, InputRegions regions)
{
    private readonly Lock _gate = new();
    private readonly HashSet<Key> _held = [];
    private readonly HashSet<(nint Window, MouseButton Button)> _swallowed = [];

    /// <summary>True if the key is passed on to the window.</summary>
    public bool Admits(Key key, KeyModifiers modifiers, bool isDown)
    {
        bool repeat;
        lock (_gate) repeat = IsRepeat(key, isDown);
        if (filter is null) return true;
        var press = new KeyPress(key, modifiers, isDown, repeat);
        return !Guarded(() => filter(press));
    }

    private bool IsRepeat(Key key, bool isDown)
    {
        if (isDown) return !_held.Add(key) && key != Key.None;
        _held.Remove(key);
        return false;
    }

    /// <summary>True if the press is passed on to the window.</summary>
    public bool AdmitsPress(nint window, Point at, MouseButton button)
    {
        if (!Guarded(() => regions.Press(window, at, button))) return true;
        lock (_gate) _swallowed.Add((window, button));
        return false;
    }

    /// <summary>False for the release that belongs to a swallowed press.</summary>
    public bool AdmitsRelease(nint window, MouseButton button)
    {
        lock (_gate) return !_swallowed.Remove((window, button));
    }

    /// <summary>Forgets the held keys: their release is not reported while another window has the keyboard.</summary>
    public void ForgetHeldKeys()
    {
        lock (_gate) _held.Clear();
    }

    private bool Guarded(Func<bool> asked)
    {
        try
        {
            return asked();
        }
        catch (Exception e) // the input thread must not end: it logs exceptions of callbacks and continues
        {
            Logger.TryGet(LogEventLevel.Error, LogArea.Platform)?.Log(this, "A callback on the input thread failed: {Exception}", e);
            return false;
        }
    }
}
