using Avalonia;

namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Rectangle of whole device pixels; right and bottom are outside.</summary>
internal readonly record struct PixelBounds(int Left, int Top, int Right, int Bottom)
{
    private const double MaxCoordinate = 1e8;

    public int Width => Right - Left;

    public int Height => Bottom - Top;

    public bool IsEmpty => Right <= Left || Bottom <= Top;

    public PixelBounds Intersect(PixelBounds other) =>
        new(Math.Max(Left, other.Left), Math.Max(Top, other.Top), Math.Min(Right, other.Right), Math.Min(Bottom, other.Bottom));

    public PixelBounds Union(PixelBounds other) =>
        new(Math.Min(Left, other.Left), Math.Min(Top, other.Top), Math.Max(Right, other.Right), Math.Max(Bottom, other.Bottom));

    public bool Intersects(PixelBounds other) => Left < other.Right && other.Left < Right && Top < other.Bottom && other.Top < Bottom;

    public bool Contains(PixelBounds other) => other.Left >= Left && other.Top >= Top && other.Right <= Right && other.Bottom <= Bottom;

    public PixelBounds Inflate(int by) => new(Left - by, Top - by, Right + by, Bottom + by);

    public PixelBounds Offset(int x, int y) => new(Left + x, Top + y, Right + x, Bottom + y);

    /// <summary>Every pixel that the rectangle touches.</summary>
    public static PixelBounds Around(Rect rectangle) => new(
        (int)Math.Floor(Within(rectangle.X)),
        (int)Math.Floor(Within(rectangle.Y)),
        (int)Math.Ceiling(Within(rectangle.Right)),
        (int)Math.Ceiling(Within(rectangle.Bottom)));

    /// <summary>Edges moved to the nearest pixel borders.</summary>
    public static PixelBounds Snapped(Rect rectangle) =>
        new(Nearest(rectangle.X), Nearest(rectangle.Y), Nearest(rectangle.Right), Nearest(rectangle.Bottom));

    public static int Nearest(double value) => (int)Math.Floor(Within(value) + 0.5);

    private static double Within(double value) => double.IsNaN(value) ? 0 : Math.Clamp(value, -MaxCoordinate, MaxCoordinate);
}
