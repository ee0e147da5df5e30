using Avalonia.Media.Imaging;

namespace Engraver.SoftwarePlatform.Rasteriser.Paints;

/// <summary>Source of the colours of a filled shape.</summary>
internal abstract class Paint
{
    /// <summary>Every pixel it gives has full alpha.</summary>
    public abstract bool IsOpaque { get; }

    /// <summary>How its pixels are blended with what is beneath; only bitmaps use modes other than source-over.</summary>
    public BitmapBlendingMode Mode { get; init; } = BitmapBlendingMode.SourceOver;

    public bool IsPlainOver => Mode is BitmapBlendingMode.SourceOver or BitmapBlendingMode.Unspecified;

    /// <summary>Gives the premultiplied pixels of a device row from <paramref name="x"/> on, as seen at the pixels' centres.</summary>
    public abstract void Shade(int x, int y, Span<uint> row);
}
