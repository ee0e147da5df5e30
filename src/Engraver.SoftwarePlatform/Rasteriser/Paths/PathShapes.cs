using Avalonia;

namespace Engraver.SoftwarePlatform.Rasteriser.Paths;

/// <summary>Adds whole shapes to a path as one closed figure each, clockwise on screen.</summary>
internal static class PathShapes
{
    /// <summary>Length of the handles of a cubic that approximates a quarter of a unit circle (largest error 0.00027 radii).</summary>
    private const double CircleHandle = 0.5522847498307936;

    public static void AddRectangle(this VectorPath path, Rect rectangle)
    {
        path.MoveTo(rectangle.TopLeft);
        path.LineTo(rectangle.TopRight);
        path.LineTo(rectangle.BottomRight);
        path.LineTo(rectangle.BottomLeft);
        path.Close();
    }

    public static void AddEllipse(this VectorPath path, Rect box)
    {
        var centre = box.Center;
        var half = new Vector(box.Width / 2, box.Height / 2);
        path.MoveTo(centre + new Vector(half.X, 0));
        AddCorner(path, new Point(centre.X + half.X, centre.Y + half.Y), new Point(centre.X, centre.Y + half.Y));
        AddCorner(path, new Point(centre.X - half.X, centre.Y + half.Y), new Point(centre.X - half.X, centre.Y));
        AddCorner(path, new Point(centre.X - half.X, centre.Y - half.Y), new Point(centre.X, centre.Y - half.Y));
        AddCorner(path, new Point(centre.X + half.X, centre.Y - half.Y), new Point(centre.X + half.X, centre.Y));
        path.Close();
    }

    /// <summary>Adds a rounded rectangle; radii larger than half a side are reduced to half the side.</summary>
    public static void AddRoundedRectangle(this VectorPath path, RoundedRect rounded)
    {
        var box = rounded.Rect;
        var topLeft = Fit(rounded.RadiiTopLeft, box);
        var topRight = Fit(rounded.RadiiTopRight, box);
        var bottomRight = Fit(rounded.RadiiBottomRight, box);
        var bottomLeft = Fit(rounded.RadiiBottomLeft, box);
        path.MoveTo(new Point(box.X + topLeft.X, box.Y));
        path.LineTo(new Point(box.Right - topRight.X, box.Y));
        AddCorner(path, box.TopRight, new Point(box.Right, box.Y + topRight.Y));
        path.LineTo(new Point(box.Right, box.Bottom - bottomRight.Y));
        AddCorner(path, box.BottomRight, new Point(box.Right - bottomRight.X, box.Bottom));
        path.LineTo(new Point(box.X + bottomLeft.X, box.Bottom));
        AddCorner(path, box.BottomLeft, new Point(box.X, box.Bottom - bottomLeft.Y));
        path.LineTo(new Point(box.X, box.Y + topLeft.Y));
        AddCorner(path, box.TopLeft, new Point(box.X + topLeft.X, box.Y));
        path.Close();
    }

    /// <summary>The same shape grown by <paramref name="distance"/> on every side (negative: shrunk). Square corners stay square.</summary>
    public static RoundedRect Grown(this RoundedRect rounded, double distance) => new(
        rounded.Rect.Inflate(distance),
        GrownRadius(rounded.RadiiTopLeft, distance),
        GrownRadius(rounded.RadiiTopRight, distance),
        GrownRadius(rounded.RadiiBottomRight, distance),
        GrownRadius(rounded.RadiiBottomLeft, distance));

    private static Vector GrownRadius(Vector radius, double distance) =>
        radius.X <= 0 || radius.Y <= 0 ? default : new Vector(Math.Max(0, radius.X + distance), Math.Max(0, radius.Y + distance));

    private static Vector Fit(Vector radius, Rect box) =>
        new(Math.Clamp(radius.X, 0, Math.Max(0, box.Width / 2)), Math.Clamp(radius.Y, 0, Math.Max(0, box.Height / 2)));

    private static void AddCorner(VectorPath path, Point corner, Point end)
    {
        var start = path.Current;
        if (start == end)
            return;
        path.CubicTo(start + (corner - start) * CircleHandle, end + (corner - end) * CircleHandle, end);
    }
}
