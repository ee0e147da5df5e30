using Avalonia;
using Avalonia.Platform;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>One primary screen without panels: the X server's default screen, or the desktop in memory.</summary>
internal sealed class SingleScreen(Func<PixelSize> size, Func<double> scale) : ScreensBase<int, PlatformScreen>
{
    protected override IReadOnlyList<int> GetAllScreenKeys() => [1];

    protected override PlatformScreen CreateScreenFromKey(int key) => new WholeScreen(size(), scale());

    private sealed class WholeScreen : PlatformScreen
    {
        public WholeScreen(PixelSize size, double scale) : base(new PlatformHandle(1, "Screen"))
        {
            Scaling = scale;
            Bounds = WorkingArea = new PixelRect(size);
            IsPrimary = true;
        }
    }
}
