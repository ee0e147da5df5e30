namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>What stands outside an image.</summary>
internal enum ImageWrap
{
    /// <summary>Nothing: transparent.</summary>
    None,

    /// <summary>The nearest pixel of the border.</summary>
    Clamp,

    Repeat,

    Mirror,
}
