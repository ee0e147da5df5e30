using Avalonia;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Rendering;
using Avalonia.Threading;
using Engraver.SoftwarePlatform.Input;
using Engraver.SoftwarePlatform.Windows;
using Engraver.SoftwarePlatform.X11.Selections;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>Assembles the X11 front end.</summary>
internal static class X11Setup
{
    private const int FramesPerSecond = 60;
    private const int ExitCode = 1;

    public static void Bind(SoftwarePlatformOptions options, InputGate gate)
    {
        var desktop = new X11Desktop(options, gate, () => EndApplication(options));
        Dispatcher.InitializeUIThreadDispatcher(new SoftwareDispatcher(TimeProvider.System));
        var seat = new Seat(gate, new SingleScreen(() => desktop.ScreenSize, () => desktop.Scale), TimeProvider.System);
        PlatformServices.Bind(seat, new UiThreadRenderTimer(FramesPerSecond), new X11Clipboard(desktop), () => new X11Window(desktop, seat));
        desktop.Events.Start();
    }

    private static void EndApplication(SoftwarePlatformOptions options)
    {
        options.DisplayLost?.Invoke(new DisplayUnavailableException("The X display has gone, so the windows are closed."));
        Dispatcher.UIThread.Post(ShutDown, DispatcherPriority.Send);
    }

    private static void ShutDown()
    {
        if (Application.Current?.ApplicationLifetime is IControlledApplicationLifetime lifetime) lifetime.Shutdown(ExitCode);
        else Dispatcher.UIThread.BeginInvokeShutdown(DispatcherPriority.Send);
    }
}
