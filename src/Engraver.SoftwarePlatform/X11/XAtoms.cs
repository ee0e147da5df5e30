namespace Engraver.SoftwarePlatform.X11;

/// <summary>The atoms of one X server, asked for once.</summary>
internal sealed class XAtoms(nint display)
{
    public const nint None = 0;
    public const nint Atom = 4;
    public const nint Cardinal = 6;
    public const nint Integer = 19;
    public const nint String = 31;
    public const nint WmHints = 35;
    public const nint WmName = 39;
    public const nint WmNormalHints = 40;
    public const nint WmSizeHints = 41;
    public const nint WmClass = 67;

    public nint Clipboard { get; } = Of(display, "CLIPBOARD");

    public nint Targets { get; } = Of(display, "TARGETS");

    public nint Timestamp { get; } = Of(display, "TIMESTAMP");

    public nint Incr { get; } = Of(display, "INCR");

    public nint Utf8String { get; } = Of(display, "UTF8_STRING");

    public nint Text { get; } = Of(display, "TEXT");

    public nint TextPlain { get; } = Of(display, "text/plain");

    public nint TextPlainUtf8 { get; } = Of(display, "text/plain;charset=utf-8");

    public nint UriList { get; } = Of(display, "text/uri-list");

    /// <summary>The property of our helper window that selections are delivered to.</summary>
    public nint Delivery { get; } = Of(display, "SOFTWARE_PLATFORM_SELECTION");

    /// <summary>The same for what is dragged.</summary>
    public nint DropDelivery { get; } = Of(display, "SOFTWARE_PLATFORM_DROP");

    public nint WmProtocols { get; } = Of(display, "WM_PROTOCOLS");

    public nint WmDeleteWindow { get; } = Of(display, "WM_DELETE_WINDOW");

    public nint NetWmPing { get; } = Of(display, "_NET_WM_PING");

    public nint NetWmName { get; } = Of(display, "_NET_WM_NAME");

    public nint NetWmIcon { get; } = Of(display, "_NET_WM_ICON");

    public nint NetWmPid { get; } = Of(display, "_NET_WM_PID");

    public nint WmClientMachine { get; } = Of(display, "WM_CLIENT_MACHINE");

    public nint NetWmWindowType { get; } = Of(display, "_NET_WM_WINDOW_TYPE");

    public nint NetWmWindowTypeDialog { get; } = Of(display, "_NET_WM_WINDOW_TYPE_DIALOG");

    public nint NetWmWindowTypeNormal { get; } = Of(display, "_NET_WM_WINDOW_TYPE_NORMAL");

    public nint NetWmState { get; } = Of(display, "_NET_WM_STATE");

    public nint NetWmStateModal { get; } = Of(display, "_NET_WM_STATE_MODAL");

    public nint NetWmStateHidden { get; } = Of(display, "_NET_WM_STATE_HIDDEN");

    public nint NetWmStateFullscreen { get; } = Of(display, "_NET_WM_STATE_FULLSCREEN");

    public nint NetWmStateMaximizedHorizontally { get; } = Of(display, "_NET_WM_STATE_MAXIMIZED_HORZ");

    public nint NetWmStateMaximizedVertically { get; } = Of(display, "_NET_WM_STATE_MAXIMIZED_VERT");

    public nint NetWmStateAbove { get; } = Of(display, "_NET_WM_STATE_ABOVE");

    public nint NetWmStateSkipTaskbar { get; } = Of(display, "_NET_WM_STATE_SKIP_TASKBAR");

    public nint NetActiveWindow { get; } = Of(display, "_NET_ACTIVE_WINDOW");

    public nint NetSupportingWmCheck { get; } = Of(display, "_NET_SUPPORTING_WM_CHECK");

    public nint MotifWmHints { get; } = Of(display, "_MOTIF_WM_HINTS");

    public nint XdndAware { get; } = Of(display, "XdndAware");

    public nint XdndEnter { get; } = Of(display, "XdndEnter");

    public nint XdndPosition { get; } = Of(display, "XdndPosition");

    public nint XdndStatus { get; } = Of(display, "XdndStatus");

    public nint XdndLeave { get; } = Of(display, "XdndLeave");

    public nint XdndDrop { get; } = Of(display, "XdndDrop");

    public nint XdndFinished { get; } = Of(display, "XdndFinished");

    public nint XdndSelection { get; } = Of(display, "XdndSelection");

    public nint XdndTypeList { get; } = Of(display, "XdndTypeList");

    public nint XdndActionCopy { get; } = Of(display, "XdndActionCopy");

    private static nint Of(nint display, string name) => Xlib.XInternAtom(display, name, 0);
}
