using Avalonia;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Views;

/// <summary>The part of the drawing that the canvas shows. Drawing units; pixels are those of the screen, x to the right, y down, from the upper left
/// corner.</summary>
/// <param name="Centre">The point in the middle of the picture.</param>
/// <param name="UnitsPerPixel">Drawing units per pixel, above 0.</param>
public readonly record struct CanvasView(Point2D Centre, double UnitsPerPixel, PixelSize Size)
{
    public double PixelsPerUnit => 1.0 / UnitsPerPixel;

    /// <summary>The visible part of the drawing, drawing units.</summary>
    public Bounds2D Window => WindowOf(0.0, 0.0, Size.Width, Size.Height);

    /// <summary>The view in which a box fills the picture except for a margin. An empty or point-like box is shown as if it were one unit wide.</summary>
    /// <param name="margin">Fraction of the picture that stays free on each side, below 0.5.</param>
    public static CanvasView Fitting(Bounds2D box, PixelSize size, double margin = 0.03)
    {
        if (box.IsEmpty) box = new Bounds2D(-0.5, -0.5, 0.5, 0.5);
        var middle = new Point2D((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0);
        var free = 1.0 - (2.0 * margin);
        var units = Math.Max(box.Width / Math.Max(1.0, size.Width * free), box.Height / Math.Max(1.0, size.Height * free));
        return new CanvasView(middle, units > 0.0 ? units : 1.0 / Math.Max(1, size.Width), size);
    }

    public Point2D ToPixels(Point2D place) => new(
        ((place.X - Centre.X) * PixelsPerUnit) + (Size.Width / 2.0),
        ((Centre.Y - place.Y) * PixelsPerUnit) + (Size.Height / 2.0));

    public Point2D ToDrawing(Point2D pixel) => new(
        Centre.X + ((pixel.X - (Size.Width / 2.0)) * UnitsPerPixel),
        Centre.Y - ((pixel.Y - (Size.Height / 2.0)) * UnitsPerPixel));

    /// <summary>The part of the drawing under a rectangle of pixels.</summary>
    public Bounds2D WindowOf(double left, double top, double width, double height) =>
        Bounds2D.FromCorners(ToDrawing(new Point2D(left, top)), ToDrawing(new Point2D(left + width, top + height)));

    /// <summary>The view enlarged (factor above 1) or shrunk around the point under a pixel.</summary>
    public CanvasView ZoomedAbout(Point2D pixel, double factor)
    {
        var place = ToDrawing(pixel);
        return new CanvasView(place + ((Centre - place) * (1.0 / factor)), UnitsPerPixel / factor, Size);
    }

    /// <summary>The view after moving the drawing by a number of pixels.</summary>
    public CanvasView PannedBy(Vector2D pixels) => this with { Centre = Centre + new Vector2D(-pixels.X * UnitsPerPixel, pixels.Y * UnitsPerPixel) };
}
