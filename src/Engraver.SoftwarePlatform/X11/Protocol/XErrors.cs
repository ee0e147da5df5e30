using System.Runtime.InteropServices;
using Avalonia.Logging;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>Replaces Xlib's error handlers, which end the process: a refused request is logged, and a lost connection is reported to a callback.</summary>
internal static unsafe class XErrors
{
    public static void LogRefusedRequests()
    {
        Xlib.XSetErrorHandler(&OnError);
        Xlib.XSetIOErrorHandler(&OnLost);
    }

    /// <param name="connection">The connection to watch.</param>
    /// <param name="lost">Called on the thread that noticed the loss; must not call Xlib.</param>
    public static void WhenLost(XConnection connection, Action lost)
    {
        if (!NativeLibrary.TryGetExport(NativeLibrary.Load(Xlib.Library), nameof(Xlib.XSetIOErrorExitHandler), out _)) return; // libX11 before 1.7
        var kept = GCHandle.Alloc(lost); // for as long as the process may use the connection
        Xlib.XSetIOErrorExitHandler(connection.Display, &OnExit, (void*)GCHandle.ToIntPtr(kept));
    }

    [UnmanagedCallersOnly]
    private static int OnError(nint display, XErrorEvent* error)
    {
        Logger.TryGet(LogEventLevel.Warning, LogArea.X11Platform)?.Log(null, "X refused request {Request} with error {Code} for {Resource}",
            (int)error->RequestCode, (int)error->ErrorCode, (long)error->Resource);
        return 0;
    }

    [UnmanagedCallersOnly]
    private static int OnLost(nint display) => 0;

    [UnmanagedCallersOnly]
    private static void OnExit(nint display, void* userData) => ((Action)GCHandle.FromIntPtr((nint)userData).Target!)();
}

/// <summary>A request that the server refused (X11/Xlib.h, 64-bit Linux).</summary>
[StructLayout(LayoutKind.Explicit, Size = 40)]
internal struct XErrorEvent
{
    [FieldOffset(16)] public nint Resource;
    [FieldOffset(32)] public byte ErrorCode;
    [FieldOffset(33)] public byte RequestCode;
}
