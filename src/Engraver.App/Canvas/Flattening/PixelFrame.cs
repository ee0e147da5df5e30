using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Flattening;

/// <summary>Converts drawing units to pixels. The centre of the view is subtracted first, in double: at a zoom of a million a pixel still has six
/// decimals.</summary>
internal readonly record struct PixelFrame(double CentreX, double CentreY, double Scale, double MiddleX, double MiddleY)
{
    public static PixelFrame From(CanvasView view) => new(view.Centre.X, view.Centre.Y, view.PixelsPerUnit, view.Size.Width / 2.0, view.Size.Height / 2.0);

    public double X(double x) => ((x - CentreX) * Scale) + MiddleX;

    public double Y(double y) => ((CentreY - y) * Scale) + MiddleY;

    /// <summary>Converts a box of the drawing to a box of pixels (y down).</summary>
    public Bounds2D Box(in Bounds2D box) => new(X(box.MinX), Y(box.MaxY), X(box.MaxX), Y(box.MinY));
}
