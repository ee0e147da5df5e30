using System.Runtime.InteropServices;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>The part of libX11 that is used: connections, windows, properties, keyboard, input methods, cursors and pictures.</summary>
/// <remarks>Names and arguments are Xlib's; C's <c>long</c> is <c>nint</c> (64-bit Linux). Requests are declared without a result, because errors are reported
/// later.</remarks>
internal static unsafe partial class Xlib
{
    public const string Library = "libX11.so.6";

    [LibraryImport(Library)]
    public static partial void XInitThreads();

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial nint XOpenDisplay(string? name);

    [LibraryImport(Library)]
    public static partial void XCloseDisplay(nint display);

    [LibraryImport(Library)]
    public static partial int XConnectionNumber(nint display);

    [LibraryImport(Library)]
    public static partial int XDefaultScreen(nint display);

    [LibraryImport(Library)]
    public static partial nint XRootWindow(nint display, int screen);

    [LibraryImport(Library)]
    public static partial int XDisplayWidth(nint display, int screen);

    [LibraryImport(Library)]
    public static partial int XDisplayHeight(nint display, int screen);

    [LibraryImport(Library)]
    public static partial nint XDefaultVisual(nint display, int screen);

    [LibraryImport(Library)]
    public static partial int XDefaultDepth(nint display, int screen);

    [LibraryImport(Library)]
    public static partial nint XResourceManagerString(nint display);

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial nint XInternAtom(nint display, string name, int onlyIfExists);

    [LibraryImport(Library)]
    public static partial void XFlush(nint display);

    [LibraryImport(Library)]
    public static partial void XSync(nint display, int discard);

    [LibraryImport(Library)]
    public static partial int XPending(nint display);

    [LibraryImport(Library)]
    public static partial void XNextEvent(nint display, XEvent* received);

    [LibraryImport(Library)]
    public static partial int XCheckTypedWindowEvent(nint display, nint window, int type, XEvent* received);

    [LibraryImport(Library)]
    public static partial void XSendEvent(nint display, nint window, int propagate, nint mask, XEvent* sent);

    [LibraryImport(Library)]
    public static partial void XSelectInput(nint display, nint window, nint mask);

    [LibraryImport(Library)]
    public static partial nint XCreateWindow(nint display, nint parent, int x, int y, uint width, uint height, uint border, int depth, uint windowClass, nint visual,
        nuint mask, XSetWindowAttributes* attributes);

    [LibraryImport(Library)]
    public static partial void XDestroyWindow(nint display, nint window);

    [LibraryImport(Library)]
    public static partial void XMapRaised(nint display, nint window);

    [LibraryImport(Library)]
    public static partial void XWithdrawWindow(nint display, nint window, int screen);

    [LibraryImport(Library)]
    public static partial void XIconifyWindow(nint display, nint window, int screen);

    [LibraryImport(Library)]
    public static partial void XRaiseWindow(nint display, nint window);

    [LibraryImport(Library)]
    public static partial void XMoveWindow(nint display, nint window, int x, int y);

    [LibraryImport(Library)]
    public static partial void XResizeWindow(nint display, nint window, uint width, uint height);

    [LibraryImport(Library)]
    public static partial void XSetInputFocus(nint display, nint window, int revertTo, nint time);

    [LibraryImport(Library)]
    public static partial void XSetTransientForHint(nint display, nint window, nint owner);

    [LibraryImport(Library)]
    public static partial void XTranslateCoordinates(nint display, nint from, nint to, int x, int y, out int toX, out int toY, out nint child);

    [LibraryImport(Library)]
    public static partial void XChangeProperty(nint display, nint window, nint property, nint type, int format, int mode, void* data, int count);

    [LibraryImport(Library)]
    public static partial void XDeleteProperty(nint display, nint window, nint property);

    [LibraryImport(Library)]
    public static partial int XGetWindowProperty(nint display, nint window, nint property, nint offset, nint length, int delete, nint type,
        out nint actualType, out int actualFormat, out nuint count, out nuint left, out byte* data);

    [LibraryImport(Library)]
    public static partial void XFree(void* memory);

    [LibraryImport(Library)]
    public static partial nint XSetSelectionOwner(nint display, nint selection, nint owner, nint time);

    [LibraryImport(Library)]
    public static partial nint XGetSelectionOwner(nint display, nint selection);

    [LibraryImport(Library)]
    public static partial void XConvertSelection(nint display, nint selection, nint target, nint property, nint requestor, nint time);

    [LibraryImport(Library)]
    public static partial nint XSetErrorHandler(delegate* unmanaged<nint, XErrorEvent*, int> handler);

    [LibraryImport(Library)]
    public static partial nint XSetIOErrorHandler(delegate* unmanaged<nint, int> handler);

    /// <summary>Since libX11 1.7: sets a handler that is called instead of <c>exit</c> when the connection is lost.</summary>
    [LibraryImport(Library)]
    public static partial void XSetIOErrorExitHandler(nint display, delegate* unmanaged<nint, void*, void> handler, void* userData);

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
