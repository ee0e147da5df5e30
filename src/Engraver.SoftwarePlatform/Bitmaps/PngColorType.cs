namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Numbers as they stand in the file.</summary>
internal enum PngColorType
{
    Gray = 0,
    TrueColor = 2,
    Palette = 3,
    GrayWithAlpha = 4,
    TrueColorWithAlpha = 6,
}
