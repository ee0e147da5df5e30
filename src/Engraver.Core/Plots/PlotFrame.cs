using Engraver.Core.Geometry;

namespace Engraver.Core.Plots;

/// <summary>Converts millimetres to picture units: the longer side of the drawing fills the picture, y points up in the drawing and down in the
/// picture.</summary>
internal sealed class PlotFrame
{
    public const double CaptionHeight = 54.0;
    private const double LongSide = 1200.0;
    private const double MinShortSide = 200.0;
    private const double Margin = 44.0;
    private readonly Point2D _middle;

    public PlotFrame(Bounds2D seen)
    {
        var extent = Math.Max(seen.Width, seen.Height);
        Scale = extent > 0.0 ? LongSide / extent : 1.0;
        _middle = seen.IsEmpty ? default : new Point2D((seen.MinX + seen.MaxX) / 2.0, (seen.MinY + seen.MaxY) / 2.0);
        FieldWidth = Math.Max(LongSide / 2.0, seen.Width * Scale) + (2.0 * Margin);
        FieldHeight = Math.Max(MinShortSide, seen.Height * Scale) + (2.0 * Margin);
    }

    /// <summary>Picture units per millimetre.</summary>
    public double Scale { get; }

    public double FieldWidth { get; }

    public double FieldHeight { get; }

    public double Height => FieldHeight + CaptionHeight;

    public Point2D Place(Point2D drawing) => new(
        (FieldWidth / 2.0) + ((drawing.X - _middle.X) * Scale),
        (FieldHeight / 2.0) - ((drawing.Y - _middle.Y) * Scale));

    public static Vector2D Turn(Vector2D drawing) => new(drawing.X, -drawing.Y);
}
