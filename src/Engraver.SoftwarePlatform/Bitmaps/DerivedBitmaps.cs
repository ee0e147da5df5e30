using Avalonia;

namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Directly readable copies of one version of a bitmap: converted, halved once, twice and so on. Made when first needed.</summary>
internal sealed class DerivedBitmaps(SoftwareBitmap original) : IDisposable
{
    private readonly List<SoftwareBitmap> _levels = [];

    public int Version { get; } = original.Version;

    public SoftwareBitmap Get(int halvings)
    {
        if (_levels.Count == 0)
            _levels.Add(original.IsDirectlyReadable ? original : Copied(original));
        while (_levels.Count <= halvings)
            _levels.Add(Halved(_levels[^1]));
        return _levels[halvings];
    }

    public void Dispose()
    {
        foreach (var level in _levels)
        {
            if (level != original)
                level.Dispose();
        }
        _levels.Clear();
    }

    private static SoftwareBitmap Copied(SoftwareBitmap source)
    {
        var copy = new SoftwareBitmap(source.PixelSize, source.Dpi);
        for (var y = 0; y < source.PixelSize.Height; y++)
        {
            var from = source.Row(y);
            var to = copy.Row(y);
            for (var x = 0; x < to.Length; x++)
                to[x] = source.Converted(from[x]);
        }
        return copy;
    }

    private static SoftwareBitmap Halved(SoftwareBitmap source) =>
        BitmapScaling.Averaged(source, new PixelSize((source.PixelSize.Width + 1) / 2, (source.PixelSize.Height + 1) / 2));
}
