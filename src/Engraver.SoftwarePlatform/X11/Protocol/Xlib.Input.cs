using System.Runtime.InteropServices;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <content>Keyboard, input methods, cursors and pictures.</content>
internal static unsafe partial class Xlib
{
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial nint XSetLocaleModifiers(string modifiers);

    [LibraryImport(Library)]
    public static partial nint XOpenIM(nint display, nint database, nint name, nint className);

    /// <summary>Variadic in C: pairs of a name and a value, ended by a null name. Passing word-sized arguments is the same call on x64 and arm64
    /// Linux.</summary>
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial nint XCreateIC(nint inputMethod, string name1, nint value1, string name2, nint value2, string name3, nint value3, nint end);

    [LibraryImport(Library)]
    public static partial void XDestroyIC(nint inputContext);

    [LibraryImport(Library)]
    public static partial void XSetICFocus(nint inputContext);

    [LibraryImport(Library)]
    public static partial void XUnsetICFocus(nint inputContext);

    [LibraryImport(Library)]
    public static partial int XFilterEvent(XEvent* received, nint window);

    [LibraryImport(Library)]
    public static partial int Xutf8LookupString(nint inputContext, XEvent* key, byte* text, int size, out nint keysym, out int status);

    [LibraryImport(Library)]
    public static partial int XLookupString(XEvent* key, byte* text, int size, out nint keysym, nint status);

    [LibraryImport(Library)]
    public static partial nint XkbKeycodeToKeysym(nint display, byte keycode, int group, int level);

    [LibraryImport(Library)]
    public static partial void XkbSetDetectableAutoRepeat(nint display, int detectable, nint supported);

    [LibraryImport(Library)]
    public static partial void XRefreshKeyboardMapping(XEvent* mapping);

    [LibraryImport(Library)]
    public static partial nint XCreateFontCursor(nint display, uint shape);

    [LibraryImport(Library)]
    public static partial nint XCreateBitmapFromData(nint display, nint drawable, byte* bits, uint width, uint height);

    [LibraryImport(Library)]
    public static partial nint XCreatePixmapCursor(nint display, nint source, nint mask, XColor* foreground, XColor* background, uint hotX, uint hotY);

    [LibraryImport(Library)]
    public static partial void XFreePixmap(nint display, nint pixmap);

    [LibraryImport(Library)]
    public static partial void XFreeCursor(nint display, nint cursor);

    [LibraryImport(Library)]
    public static partial void XDefineCursor(nint display, nint window, nint cursor);

    [LibraryImport(Library)]
    public static partial nint XCreateGC(nint display, nint drawable, nuint mask, nint values);

    [LibraryImport(Library)]
    public static partial void XFreeGC(nint display, nint context);

    [LibraryImport(Library)]
    public static partial nint XCreateImage(nint display, nint visual, uint depth, int format, int offset, void* data, uint width, uint height, int pad, int bytesPerLine);

    [LibraryImport(Library)]
    public static partial void XPutImage(nint display, nint drawable, nint context, nint image, int sourceX, int sourceY, int x, int y, uint width, uint height);
}

/// <summary>A colour of 16 bits a channel (X11/Xlib.h, 64-bit Linux).</summary>
[StructLayout(LayoutKind.Explicit, Size = 16)]
internal struct XColor
{
    [FieldOffset(8)] public ushort Red;
    [FieldOffset(10)] public ushort Green;
    [FieldOffset(12)] public ushort Blue;
    [FieldOffset(14)] public byte Flags;
}
