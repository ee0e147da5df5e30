using System.Runtime.InteropServices;

namespace Engraver.Benchmarks.Desktop;

/// <summary>Sends keys to an X server over its own connection (XTEST): they reach the window in front as those of a real keyboard do.</summary>
internal sealed partial class XTestKeyboard : IDisposable
{
    private readonly nint _display;

    /// <exception cref="DllNotFoundException">libX11 or libXtst is not installed.</exception>
    /// <exception cref="InvalidOperationException">There is no X server.</exception>
    public XTestKeyboard()
    {
        _display = XOpenDisplay(null);
        if (_display == 0) throw new InvalidOperationException("There is no X server to press keys on.");
    }

    /// <summary>Presses (down) or releases a key; the request has been sent when this returns.</summary>
    public void Send(nuint keysym, bool down)
    {
        _ = XTestFakeKeyEvent(_display, XKeysymToKeycode(_display, keysym), down ? 1 : 0, 0);
        _ = XFlush(_display);
    }

    public void Dispose() => _ = XCloseDisplay(_display);

    [LibraryImport("libX11.so.6", StringMarshalling = StringMarshalling.Utf8)]
    private static partial nint XOpenDisplay(string? name);

    [LibraryImport("libX11.so.6")]
    private static partial uint XKeysymToKeycode(nint display, nuint keysym);

    [LibraryImport("libX11.so.6")]
    private static partial int XFlush(nint display);

    [LibraryImport("libX11.so.6")]
    private static partial int XCloseDisplay(nint display);

    [LibraryImport("libXtst.so.6")]
    private static partial int XTestFakeKeyEvent(nint display, uint keycode, int isPress, nuint delay);
}
