using Avalonia;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Geometry;

/// <summary>A few rectangles of device pixels that do not overlap.</summary>
internal sealed class SoftwareRegion : IPlatformRenderInterfaceRegion
{
    private readonly List<LtrbPixelRect> _rectangles = [];

    public bool IsEmpty => _rectangles.Count == 0;

    public IList<LtrbPixelRect> Rects => _rectangles;

    public LtrbPixelRect Bounds
    {
        get
        {
            if (IsEmpty)
                return default;
            var bounds = PixelsOf(_rectangles[0]);
            foreach (var rectangle in _rectangles)
                bounds = bounds.Union(PixelsOf(rectangle));
            return RectangleOf(bounds);
        }
    }

    /// <summary>Adds the parts of a rectangle that are not covered yet.</summary>
    public void AddRect(LtrbPixelRect rect)
    {
        var parts = new List<PixelBounds> { PixelsOf(rect) };
        foreach (var known in _rectangles)
            parts = [.. parts.SelectMany(part => Without(part, PixelsOf(known)))];
        _rectangles.AddRange(parts.Where(part => !part.IsEmpty).Select(RectangleOf));
    }

    public void Reset() => _rectangles.Clear();

    public bool Intersects(LtrbRect rect)
    {
        foreach (var own in _rectangles)
        {
            if (own.Left < rect.Right && own.Right > rect.Left && own.Top < rect.Bottom && own.Bottom > rect.Top)
                return true;
        }
        return false;
    }

    public bool Contains(Point pt)
    {
        foreach (var own in _rectangles)
        {
            if (pt.X >= own.Left && pt.X < own.Right && pt.Y >= own.Top && pt.Y < own.Bottom)
                return true;
        }
        return false;
    }

    public void Dispose()
    {
    }

    internal PixelBounds[] ToBounds() => [.. _rectangles.Select(PixelsOf)];

    /// <summary>Up to four parts: above, below, left and right of the hole.</summary>
    private static IEnumerable<PixelBounds> Without(PixelBounds part, PixelBounds hole)
    {
        var cut = part.Intersect(hole);
        if (cut.IsEmpty)
            return [part];
        PixelBounds[] around =
        [
            part with { Bottom = cut.Top },
            part with { Top = cut.Bottom },
            new(part.Left, cut.Top, cut.Left, cut.Bottom),
            new(cut.Right, cut.Top, part.Right, cut.Bottom),
        ];
        return around.Where(piece => !piece.IsEmpty);
    }

    private static PixelBounds PixelsOf(LtrbPixelRect rectangle) => new(rectangle.Left, rectangle.Top, rectangle.Right, rectangle.Bottom);

    private static LtrbPixelRect RectangleOf(PixelBounds bounds) => new() { Left = bounds.Left, Top = bounds.Top, Right = bounds.Right, Bottom = bounds.Bottom };
}
