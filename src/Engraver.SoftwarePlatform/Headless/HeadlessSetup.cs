using Avalonia.Rendering;
using Avalonia.Threading;
using Engraver.SoftwarePlatform.Input;
using Engraver.SoftwarePlatform.Windows;

namespace Engraver.SoftwarePlatform.Headless;

/// <summary>Assembles the front end in memory.</summary>
internal static class HeadlessSetup
{
    public static void Bind(HeadlessDesktop desktop, SoftwarePlatformOptions options, InputGate gate)
    {
        var scale = options.Scale > 0 ? options.Scale : 1.0;
        var dispatcher = new SoftwareDispatcher(desktop.Time);
        Dispatcher.InitializeUIThreadDispatcher(dispatcher);
        var seat = new Seat(gate, new SingleScreen(() => desktop.ScreenSize, () => scale), desktop.Time);
        var frames = new ManualRenderTimer(desktop.Time);
        var clipboard = new MemoryClipboard();
        desktop.Attach(dispatcher, frames, clipboard);
        PlatformServices.Bind(seat, frames, clipboard, () => new HeadlessWindow(desktop, seat, scale));
    }
}

/// <summary>A render timer whose frames are triggered by a call.</summary>
internal sealed class ManualRenderTimer(TimeProvider time) : IRenderTimer
{
    private readonly long _start = time.GetTimestamp();

    public Action<TimeSpan>? Tick { get; set; }

    public bool RunsInBackground => false;

    /// <summary>False while nothing waits to be drawn.</summary>
    public bool IsWanted => Tick is not null;

    public void Fire() => Tick?.Invoke(time.GetElapsedTime(_start));
}
