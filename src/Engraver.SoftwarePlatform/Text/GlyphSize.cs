namespace Engraver.SoftwarePlatform.Text;

/// <summary>Size and position of a glyph, as far as its mask depends on them.</summary>
internal static class GlyphSize
{
    /// <summary>Glyphs are positioned in quarters of a pixel.</summary>
    public const int StepsPerPixel = 1 << StepBits;

    public const int StepBits = 2;

    private const double PartsPerPixel = 64;

    /// <summary>Pixels per em in 1/64.</summary>
    public static int ToParts(double pixelsPerEm) => (int)Math.Round(pixelsPerEm * PartsPerPixel);

    public static double PixelsPerEm(int size) => size / PartsPerPixel;
}
