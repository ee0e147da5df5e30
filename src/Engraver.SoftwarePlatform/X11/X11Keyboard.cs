using System.Text;
using Avalonia.Input;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>Translates keys to Avalonia's keys and text, on the event thread. The input method handles dead keys and Compose.</summary>
internal sealed unsafe class X11Keyboard
{
    private const nint PreeditAndStatusNothing = 0x8 | 0x400; // XIMPreeditNothing | XIMStatusNothing
    private readonly XConnection _connection;
    private readonly nint _inputMethod;

    /// <summary>The locale must be set before.</summary>
    public X11Keyboard(XConnection connection)
    {
        _connection = connection;
        Xlib.XSetLocaleModifiers("");
        _inputMethod = Xlib.XOpenIM(connection.Display, 0, 0, 0);
        if (_inputMethod == 0) _inputMethod = OpenBuiltIn();
        Xlib.XkbSetDetectableAutoRepeat(connection.Display, 1, 0);
    }

    /// <summary>Zero without an input method: keys then give only their own characters.</summary>
    public nint CreateContext(nint window) => _inputMethod == 0
        ? 0
        : Xlib.XCreateIC(_inputMethod, "inputStyle", PreeditAndStatusNothing, "clientWindow", window, "focusWindow", window, 0);

    /// <summary>The key in the present layout: a function key as it is, a printing key by its character without Shift.</summary>
    public Key KeyOf(ref XEvent press)
    {
        nint symbol;
        fixed (XEvent* given = &press) Xlib.XLookupString(given, null, 0, out symbol, 0);
        var group = (int)(press.State >> 13) & 3;
        if (symbol >= 0xFF00 && Keysyms.KeyOf(symbol) is var function and not Key.None) return function;
        return First(At(press, group, 0), At(press, group, 1), Keysyms.KeyOf(symbol), At(press, 0, 0), At(press, 1, 0), LatinKeys.KeyOf(press.Detail));
    }

    /// <summary>Printable text of a press, or null.</summary>
    public string? TextOf(nint context, ref XEvent press)
    {
        const int size = 256;
        var buffer = stackalloc byte[size];
        int length;
        fixed (XEvent* given = &press)
        {
            length = context != 0 ? Xlib.Xutf8LookupString(context, given, buffer, size, out _, out _) : Xlib.XLookupString(given, buffer, size, out _, 0);
        }

        if (length is <= 0 or > size || buffer[0] < ' ' || buffer[0] == 127) return null;
        return context != 0 ? Encoding.UTF8.GetString(buffer, length) : Encoding.Latin1.GetString(buffer, length);
    }

    private static Key First(params ReadOnlySpan<Key> candidates)
    {
        foreach (var key in candidates)
        {
            if (key != Key.None) return key;
        }

        return Key.None;
    }

    private Key At(in XEvent press, int group, int level) => Keysyms.KeyOf(Xlib.XkbKeycodeToKeysym(_connection.Display, (byte)press.Detail, group, level));

    /// <summary>Uses Xlib's own composing if the input method named by the environment does not respond.</summary>
    private nint OpenBuiltIn()
    {
        Xlib.XSetLocaleModifiers("@im=none");
        return Xlib.XOpenIM(_connection.Display, 0, 0, 0);
    }
}
