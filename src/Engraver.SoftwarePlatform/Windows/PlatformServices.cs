using Avalonia;
using Avalonia.Controls.Platform;
using Avalonia.Input;
using Avalonia.Input.Platform;
using Avalonia.Media.Imaging;
using Avalonia.Platform;
using Avalonia.Rendering;
using Avalonia.Rendering.Composition;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>Registers with Avalonia the services of both front ends, after the dispatcher and in the order that Avalonia needs.</summary>
internal static class PlatformServices
{
    public static void Bind(Seat seat, IRenderTimer frames, IOwnedClipboardImpl clipboard, Func<SoftwareWindow> createWindow)
    {
        AvaloniaLocator.CurrentMutable
            .Bind<IRenderLoop>().ToConstant(RenderLoop.FromTimer(frames))
            .Bind<IWindowingPlatform>().ToConstant(new SoftwareWindowing(createWindow))
            .Bind<IKeyboardDevice>().ToConstant(seat.Keyboard)
            .Bind<ICursorFactory>().ToConstant(new SoftwareCursorFactory())
            .Bind<IPlatformSettings>().ToConstant(new DefaultPlatformSettings())
            .Bind<IPlatformIconLoader>().ToConstant(new WindowIconLoader())
            .Bind<PlatformHotkeyConfiguration>().ToConstant(new PlatformHotkeyConfiguration(KeyModifiers.Control))
            .Bind<KeyGestureFormatInfo>().ToConstant(new KeyGestureFormatInfo(new Dictionary<Key, string>(), meta: "Super"))
            .Bind<IClipboardImpl>().ToConstant(clipboard)
            .Bind<IClipboard>().ToConstant(new SoftwareClipboard(clipboard))
            .Bind<IMountedVolumeInfoProvider>().ToConstant(new MountedVolumes())
            .Bind<CompositionOptions>().ToConstant(new CompositionOptions { UseRegionDirtyRectClipping = true });
        AvaloniaLocator.CurrentMutable.Bind<Compositor>().ToConstant(new Compositor(null)); // needs the render loop
    }
}

internal sealed class SoftwareCursorFactory : ICursorFactory
{
    public ICursorImpl GetCursor(StandardCursorType cursorType) => new SoftwareCursor(cursorType, null, default);

    public ICursorImpl CreateCursor(Bitmap cursor, PixelPoint hotSpot) => new SoftwareCursor(StandardCursorType.Arrow, IconPicture.From(cursor), hotSpot);
}

/// <summary>Makes the windows of one front end. Windows inside foreign windows and tray icons are not supported.</summary>
internal sealed class SoftwareWindowing(Func<SoftwareWindow> create) : IWindowingPlatform
{
    public IWindowImpl CreateWindow() => create();

    public ITopLevelImpl CreateEmbeddableTopLevel() => throw new PlatformNotSupportedException("The software platform cannot be embedded into foreign windows.");

    public IWindowImpl CreateEmbeddableWindow() => throw new PlatformNotSupportedException("The software platform cannot be embedded into foreign windows.");

    public ITrayIconImpl? CreateTrayIcon() => null;

    public void GetWindowsZOrder(ReadOnlySpan<IWindowImpl> windows, Span<long> zOrder)
    {
        for (var i = 0; i < windows.Length; i++) zOrder[i] = (windows[i] as SoftwareWindow)?.Stacking ?? 0;
    }
}
