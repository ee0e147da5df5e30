using Avalonia;
using Engraver.SoftwarePlatform.Windows;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>Sends the changed parts of a frame to its window, over the drawing connection.</summary>
internal sealed unsafe class X11Presenter(XConnection connection, nint window) : IDisposable
{
    private const int PixmapOfWholePixels = 2; // ZPixmap
    private readonly FrameDifference _difference = new();
    private nint _context;

    public void Send(WindowFrame frame)
    {
        var changed = _difference.Take(frame.Pixels, frame.Size);
        if (changed.Count > 0) Put(frame, changed);
    }

    /// <summary>Sends an area again whose content the server has lost; the frame itself has not changed.</summary>
    public void SendAgain(WindowFrame frame, PixelRect area)
    {
        var visible = area.Intersect(new PixelRect(frame.Size));
        if (visible.Width > 0 && visible.Height > 0) Put(frame, [visible]);
    }

    public void Dispose()
    {
        if (_context != 0) Xlib.XFreeGC(connection.Display, _context);
        _context = 0;
    }

    private void Put(WindowFrame frame, IReadOnlyList<PixelRect> areas)
    {
        if (_context == 0) _context = Xlib.XCreateGC(connection.Display, window, 0, 0);
        var image = Xlib.XCreateImage(connection.Display, Xlib.XDefaultVisual(connection.Display, connection.Screen), (uint)Xlib.XDefaultDepth(connection.Display, connection.Screen),
            PixmapOfWholePixels, 0, (void*)frame.Address, (uint)frame.Size.Width, (uint)frame.Size.Height, 32, frame.Stride);
        foreach (var area in areas)
        {
            Xlib.XPutImage(connection.Display, window, _context, image, area.X, area.Y, area.X, area.Y, (uint)area.Width, (uint)area.Height);
        }

        Xlib.XFree((void*)image); // frees only the description: the pixels belong to the frame
        connection.Flush();
    }
}
