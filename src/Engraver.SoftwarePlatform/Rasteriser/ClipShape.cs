namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Limits drawing: to the inside of a few rectangles, and there to the coverage of a mask. Immutable, so that a stack can hold it.</summary>
internal sealed class ClipShape
{
    private ClipShape(PixelBounds[] rectangles, CoverageMask? mask)
    {
        Rectangles = rectangles;
        Mask = mask;
        var bounds = rectangles.Length == 0 ? default : rectangles[0];
        foreach (var rectangle in rectangles)
            bounds = bounds.Union(rectangle);
        Bounds = bounds;
    }

    public ClipShape(PixelBounds bounds)
        : this(bounds.IsEmpty ? [] : [bounds], null)
    {
    }

    /// <summary>Not empty, and not overlapping.</summary>
    public PixelBounds[] Rectangles { get; }

    /// <summary>Covers at least <see cref="Bounds"/>; null when everything inside the rectangles is drawn.</summary>
    public CoverageMask? Mask { get; }

    public PixelBounds Bounds { get; }

    public bool IsEmpty => Rectangles.Length == 0;

    public ClipShape Within(PixelBounds bounds) => Within([bounds]);

    public ClipShape Within(ReadOnlySpan<PixelBounds> others)
    {
        if (others.Length == 1 && Rectangles.Length == 1 && others[0].Intersect(Bounds) == Bounds)
            return this;
        var parts = new List<PixelBounds>(Rectangles.Length);
        foreach (var own in Rectangles)
        {
            foreach (var other in others)
            {
                var part = own.Intersect(other);
                if (!part.IsEmpty)
                    parts.Add(part);
            }
        }
        return new ClipShape([.. parts], Mask);
    }

    /// <summary>The mask must already contain the coverage of this clip's own mask.</summary>
    public ClipShape WithMask(CoverageMask mask) => new(Within(mask.Bounds).Rectangles, mask);

    public ClipShape WithoutMask() => new(Rectangles, null);

    public bool Touches(PixelBounds bounds)
    {
        foreach (var rectangle in Rectangles)
        {
            if (rectangle.Intersects(bounds))
                return true;
        }
        return false;
    }

    /// <summary>True only if the clip hides no part of <paramref name="bounds"/>; false also if they are inside several rectangles together.</summary>
    public bool ShowsAll(PixelBounds bounds)
    {
        if (Mask is not null)
            return false;
        foreach (var rectangle in Rectangles)
        {
            if (rectangle.Contains(bounds))
                return true;
        }
        return false;
    }

    /// <summary>The smallest rectangle that holds the visible part of <paramref name="bounds"/>.</summary>
    public PixelBounds Visible(PixelBounds bounds)
    {
        PixelBounds visible = default;
        foreach (var rectangle in Rectangles)
        {
            var part = rectangle.Intersect(bounds);
            if (!part.IsEmpty)
                visible = visible.IsEmpty ? part : visible.Union(part);
        }
        return visible;
    }
}
