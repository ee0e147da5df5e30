using Engraver.App.Canvas.Views;

namespace Engraver.App.Canvas.Rasterising;

/// <summary>An opaque picture, rows from the top, each pixel 0xAARRGGBB (in memory blue, green, red, alpha), and its view.</summary>
internal sealed class Picture(CanvasView view)
{
    public CanvasView View { get; } = view;

    public int Width => View.Size.Width;

    public int Height => View.Size.Height;

    public uint[] Pixels { get; } = GC.AllocateUninitializedArray<uint>(view.Size.Width * view.Size.Height);
}
