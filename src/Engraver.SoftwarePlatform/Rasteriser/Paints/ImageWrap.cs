namespace Engraver.SoftwarePlatform.Rasteriser.Paints;

/// <summary>What is outside an image.</summary>
internal enum ImageWrap
{
    /// <summary>Nothing: transparent.</summary>
    None,

    /// <summary>The nearest pixel of the border.</summary>
    Clamp,

    Repeat,

    Mirror,
}
