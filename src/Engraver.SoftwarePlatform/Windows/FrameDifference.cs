using Avalonia;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>Finds the changes between a frame and the one before it, tile by tile, so that only those are sent to the display.</summary>
/// <remarks>Comparing a 1600 x 1000 frame reads 13 MB; sending it costs several times as much. Parts that the compositor redrew without a change are not
/// sent either.</remarks>
internal sealed class FrameDifference
{
    private const int TileWidth = 64;
    private const int TileHeight = 32;
    private uint[] _shown = [];
    private PixelSize _size;

    /// <summary>The rectangles that differ; from now on they count as shown. A frame of another size differs everywhere.</summary>
    public IReadOnlyList<PixelRect> Take(ReadOnlySpan<uint> pixels, PixelSize size)
    {
        if (size != _size) return TakeAll(pixels, size);
        var tiles = new TileGrid((size.Width + TileWidth - 1) / TileWidth, (size.Height + TileHeight - 1) / TileHeight);
        for (var row = 0; row < size.Height; row++) CompareRow(pixels, row, tiles);
        return tiles.Rectangles(TileWidth, TileHeight, size);
    }

    private IReadOnlyList<PixelRect> TakeAll(ReadOnlySpan<uint> pixels, PixelSize size)
    {
        _size = size;
        _shown = pixels.ToArray();
        return [new PixelRect(size)];
    }

    private void CompareRow(ReadOnlySpan<uint> pixels, int row, TileGrid tiles)
    {
        var now = pixels.Slice(row * _size.Width, _size.Width);
        var before = _shown.AsSpan(row * _size.Width, _size.Width);
        if (now.SequenceEqual(before)) return;
        for (var x = 0; x < _size.Width; x += TileWidth)
        {
            var length = Math.Min(TileWidth, _size.Width - x);
            if (!now.Slice(x, length).SequenceEqual(before.Slice(x, length))) tiles.Mark(x / TileWidth, row / TileHeight);
        }

        now.CopyTo(before);
    }
}
