namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Where the colours of a filled shape come from.</summary>
internal abstract class Paint
{
    /// <summary>Every pixel it gives has full alpha.</summary>
    public abstract bool IsOpaque { get; }

    /// <summary>Gives the premultiplied pixels of a device row from <paramref name="x"/> on, as seen at the pixels' centres.</summary>
    public abstract void Shade(int x, int y, Span<uint> row);
}
