namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>The atoms of one X server, read once.</summary>
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

    public nint Clipboard { get; } = Intern(display, "CLIPBOARD");

    public nint Targets { get; } = Intern(display, "TARGETS");

    public nint Timestamp { get; } = Intern(display, "TIMESTAMP");

    public nint Incr { get; } = Intern(display, "INCR");

    public nint Utf8String { get; } = Intern(display, "UTF8_STRING");

    public nint Text { get; } = Intern(display, "TEXT");

    public nint TextPlain { get; } = Intern(display, "text/plain");

    public nint TextPlainUtf8 { get; } = Intern(display, "text/plain;charset=utf-8");

    public nint UriList { get; } = Intern(display, "text/uri-list");

    /// <summary>The property of the helper window that selections are delivered to.</summary>
    public nint Delivery { get; } = Intern(display, "SOFTWARE_PLATFORM_SELECTION");

    /// <summary>The same for dragged data.</summary>
    public nint DropDelivery { get; } = Intern(display, "SOFTWARE_PLATFORM_DROP");

    public nint WmProtocols { get; } = Intern(display, "WM_PROTOCOLS");

    public nint WmDeleteWindow { get; } = Intern(display, "WM_DELETE_WINDOW");

    public nint NetWmPing { get; } = Intern(display, "_NET_WM_PING");

    public nint NetWmName { get; } = Intern(display, "_NET_WM_NAME");

    public nint NetWmIcon { get; } = Intern(display, "_NET_WM_ICON");

    public nint NetWmPid { get; } = Intern(display, "_NET_WM_PID");

    public nint WmClientMachine { get; } = Intern(display, "WM_CLIENT_MACHINE");

    public nint NetWmWindowType { get; } = Intern(display, "_NET_WM_WINDOW_TYPE");

    public nint NetWmWindowTypeDialog { get; } = Intern(display, "_NET_WM_WINDOW_TYPE_DIALOG");

    public nint NetWmWindowTypeNormal { get; } = Intern(display, "_NET_WM_WINDOW_TYPE_NORMAL");

    public nint NetWmState { get; } = Intern(display, "_NET_WM_STATE");

    public nint NetWmStateModal { get; } = Intern(display, "_NET_WM_STATE_MODAL");

    public nint NetWmStateHidden { get; } = Intern(display, "_NET_WM_STATE_HIDDEN");

    public nint NetWmStateFullscreen { get; } = Intern(display, "_NET_WM_STATE_FULLSCREEN");

    public nint NetWmStateMaximizedHorizontally { get; } = Intern(display, "_NET_WM_STATE_MAXIMIZED_HORZ");

    public nint NetWmStateMaximizedVertically { get; } = Intern(display, "_NET_WM_STATE_MAXIMIZED_VERT");

    public nint NetWmStateAbove { get; } = Intern(display, "_NET_WM_STATE_ABOVE");

    public nint NetWmStateSkipTaskbar { get; } = Intern(display, "_NET_WM_STATE_SKIP_TASKBAR");

    public nint NetActiveWindow { get; } = Intern(display, "_NET_ACTIVE_WINDOW");

    public nint NetSupportingWmCheck { get; } = Intern(display, "_NET_SUPPORTING_WM_CHECK");

    public nint MotifWmHints { get; } = Intern(display, "_MOTIF_WM_HINTS");

    public nint XdndAware { get; } = Intern(display, "XdndAware");

    public nint XdndEnter { get; } = Intern(display, "XdndEnter");

    public nint XdndPosition { get; } = Intern(display, "XdndPosition");

    public nint XdndStatus { get; } = Intern(display, "XdndStatus");

    public nint XdndLeave { get; } = Intern(display, "XdndLeave");

    public nint XdndDrop { get; } = Intern(display, "XdndDrop");

    public nint XdndFinished { get; } = Intern(display, "XdndFinished");

    public nint XdndSelection { get; } = Intern(display, "XdndSelection");

    public nint XdndTypeList { get; } = Intern(display, "XdndTypeList");

    public nint XdndActionCopy { get; } = Intern(display, "XdndActionCopy");

    private static nint Intern(nint display, string name) => Xlib.XInternAtom(display, name, 0);
}
