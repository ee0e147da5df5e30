namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Colour types, by their numbers in the file.</summary>
internal enum PngColorType
{
    Gray = 0,
    TrueColor = 2,
    Palette = 3,
    GrayWithAlpha = 4,
    TrueColorWithAlpha = 6,
}
