using Avalonia.Platform;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>Makes windows of one kind. Windows inside foreign windows and tray icons do not exist here.</summary>
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
