using System.Runtime.InteropServices;
using System.Text;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>One connection to an X server. Each is used by one thread only.</summary>
internal sealed unsafe class XConnection
{
    private XConnection(nint display)
    {
        Display = display;
        Screen = Xlib.XDefaultScreen(display);
        Root = Xlib.XRootWindow(display, Screen);
    }

    public nint Display { get; }

    public int Screen { get; }

    public nint Root { get; }

    /// <exception cref="DisplayUnavailableException">No library, no server, or access was refused.</exception>
    public static XConnection Open(string? name)
    {
        var display = TryOpen(name);
        if (display != 0) return new XConnection(display);
        var asked = name ?? Environment.GetEnvironmentVariable("DISPLAY");
        throw new DisplayUnavailableException(string.IsNullOrEmpty(asked)
            ? "No X display can be opened, because the environment variable DISPLAY is not set."
            : $"The X display \"{asked}\" cannot be opened: no server answers there, or it does not let this user in.");
    }

    public void SetLongs(nint window, nint property, nint type, params ReadOnlySpan<nint> values)
    {
        fixed (nint* data = values) Xlib.XChangeProperty(Display, window, property, type, 32, 0, data, values.Length);
    }

    public void SetBytes(nint window, nint property, nint type, ReadOnlySpan<byte> bytes)
    {
        byte nothing;
        fixed (byte* data = bytes) Xlib.XChangeProperty(Display, window, property, type, 8, 0, data is null ? &nothing : data, bytes.Length);
    }

    public void SetText(nint window, nint property, nint type, string text) => SetBytes(window, property, type, Encoding.UTF8.GetBytes(text));

    /// <returns>Empty when there is no such property, or when it has another format.</returns>
    public nint[] GetLongs(nint window, nint property)
    {
        if (Xlib.XGetWindowProperty(Display, window, property, 0, 1 << 20, 0, 0, out _, out var format, out var count, out _, out var data) != 0 || data is null) return [];
        var values = format == 32 ? new ReadOnlySpan<nint>(data, (int)count).ToArray() : [];
        Xlib.XFree(data);
        return values;
    }

    /// <summary>Reads a property of bytes and deletes it, as the selection protocol requires.</summary>
    public (nint Type, byte[] Bytes) TakeBytes(nint window, nint property)
    {
        const int everything = int.MaxValue / 4;
        if (Xlib.XGetWindowProperty(Display, window, property, 0, everything, 1, 0, out var type, out var format, out var count, out _, out var data) != 0) return (0, []);
        var bytes = format == 8 ? new ReadOnlySpan<byte>(data, (int)count).ToArray() : [];
        if (data is not null) Xlib.XFree(data);
        return (type, bytes);
    }

    /// <summary>Sends a message of five numbers to a window.</summary>
    /// <param name="receiver">The window itself, or the root window for the window manager.</param>
    /// <param name="about">The window that the message concerns.</param>
    /// <param name="message">Its atom.</param>
    /// <param name="mask">0, or <see cref="XEventMask.ToWindowManager"/>.</param>
    /// <param name="numbers">At most five.</param>
    public void SendMessage(nint receiver, nint about, nint message, nint mask, params ReadOnlySpan<nint> numbers)
    {
        var sent = new XEvent { Type = XEventType.ClientMessage, Window = about, MessageType = message, Format = 32 };
        for (var i = 0; i < numbers.Length; i++) sent.Data[i] = numbers[i];
        Xlib.XSendEvent(Display, receiver, 0, mask, &sent);
    }

    public string? ResourceText() => Marshal.PtrToStringUTF8(Xlib.XResourceManagerString(Display));

    public void Flush() => Xlib.XFlush(Display);

    public void Sync() => Xlib.XSync(Display, 0);

    public void Close() => Xlib.XCloseDisplay(Display);

    private static nint TryOpen(string? name)
    {
        try
        {
            Xlib.XInitThreads(); // must be the first call, because the connections are used by two threads
            return Xlib.XOpenDisplay(name);
        }
        catch (DllNotFoundException e)
        {
            throw new DisplayUnavailableException($"The library {Xlib.Library} is not installed, so no window can be shown.", e);
        }
    }
}
