using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Flattening;

/// <summary>Drawing units to pixels with the view's centre taken off first, in double: at a zoom of a million a pixel still has six decimals.</summary>
internal readonly record struct PixelFrame(double CentreX, double CentreY, double Scale, double MiddleX, double MiddleY)
{
    public static PixelFrame Of(CanvasView view) => new(view.Centre.X, view.Centre.Y, view.PixelsPerUnit, view.Size.Width / 2.0, view.Size.Height / 2.0);

    public double X(double x) => ((x - CentreX) * Scale) + MiddleX;

    public double Y(double y) => ((CentreY - y) * Scale) + MiddleY;

    /// <summary>A box of the drawing as a box of pixels (y down).</summary>
    public Bounds2D Box(in Bounds2D box) => new(X(box.MinX), Y(box.MaxY), X(box.MaxX), Y(box.MinY));
}
