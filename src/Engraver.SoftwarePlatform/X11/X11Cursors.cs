using Avalonia.Input;
using Engraver.SoftwarePlatform.Windows;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>The server's cursors: standard shapes from the cursor font, pictures as two-coloured masks (the core protocol supports no more).</summary>
internal sealed unsafe class X11Cursors(XConnection connection)
{
    private readonly Dictionary<StandardCursorType, nint> _shapes = [];
    private readonly Dictionary<SoftwareCursor, nint> _pictures = new(ReferenceEqualityComparer.Instance);

    public nint Of(SoftwareCursor? cursor)
    {
        if (cursor?.Picture is { } picture) return OfPicture(cursor, picture);
        var shape = cursor?.Shape ?? StandardCursorType.Arrow;
        if (!_shapes.TryGetValue(shape, out var made)) _shapes[shape] = made = shape == StandardCursorType.None ? Blank() : Xlib.XCreateFontCursor(connection.Display, FontShape(shape));
        return made;
    }

    /// <summary>Numbers of X11/cursorfont.h.</summary>
    internal static uint FontShape(StandardCursorType shape) => shape switch
    {
        StandardCursorType.Ibeam => 152,
        StandardCursorType.Wait or StandardCursorType.AppStarting => 150,
        StandardCursorType.Cross => 34,
        StandardCursorType.UpArrow => 22,
        StandardCursorType.SizeWestEast => 108,
        StandardCursorType.SizeNorthSouth => 116,
        StandardCursorType.SizeAll or StandardCursorType.DragMove => 52,
        StandardCursorType.No => 24,
        StandardCursorType.Hand or StandardCursorType.DragLink => 60,
        StandardCursorType.Help => 92,
        StandardCursorType.TopSide => 138,
        StandardCursorType.BottomSide => 16,
        StandardCursorType.LeftSide => 70,
        StandardCursorType.RightSide => 96,
        StandardCursorType.TopLeftCorner => 134,
        StandardCursorType.TopRightCorner => 136,
        StandardCursorType.BottomLeftCorner => 12,
        StandardCursorType.BottomRightCorner => 14,
        StandardCursorType.DragCopy => 90,
        _ => 68,
    };

    private nint Blank()
    {
        const byte nothing = 0;
        var bits = nothing;
        return Make(&bits, &bits, 1, 1, 0, 0);
    }

    private nint OfPicture(SoftwareCursor cursor, IconPicture picture)
    {
        if (_pictures.TryGetValue(cursor, out var made)) return made;
        var (shape, mask) = CursorMasks.Create(picture);
        fixed (byte* shapeBits = shape, maskBits = mask)
        {
            return _pictures[cursor] = Make(shapeBits, maskBits, (uint)picture.Size.Width, (uint)picture.Size.Height, (uint)cursor.HotSpot.X, (uint)cursor.HotSpot.Y);
        }
    }

    private nint Make(byte* shape, byte* mask, uint width, uint height, uint hotX, uint hotY)
    {
        var shapeMap = Xlib.XCreateBitmapFromData(connection.Display, connection.Root, shape, width, height);
        var maskMap = Xlib.XCreateBitmapFromData(connection.Display, connection.Root, mask, width, height);
        var white = new XColor { Red = ushort.MaxValue, Green = ushort.MaxValue, Blue = ushort.MaxValue };
        var black = default(XColor);
        var cursor = Xlib.XCreatePixmapCursor(connection.Display, shapeMap, maskMap, &white, &black, hotX, hotY);
        Xlib.XFreePixmap(connection.Display, shapeMap);
        Xlib.XFreePixmap(connection.Display, maskMap);
        return cursor;
    }
}
