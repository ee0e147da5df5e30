using System.Buffers.Binary;

namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>The content of IHDR.</summary>
internal readonly record struct PngHeader(int Width, int Height, int BitDepth, PngColorType ColorType, bool IsInterlaced)
{
    public const double MetresPerInch = 0.0254;

    private const int LargestSide = 1 << 16;

    public int Channels => ColorType switch
    {
        PngColorType.TrueColor => 3,
        PngColorType.GrayWithAlpha => 2,
        PngColorType.TrueColorWithAlpha => 4,
        _ => 1,
    };

    public int BitsPerPixel => Channels * BitDepth;

    /// <summary>Distance in bytes between the values that the row filters compare.</summary>
    public int FilterDistance => Math.Max(1, BitsPerPixel / 8);

    public int BytesPerRow(int width) => (int)(((long)width * BitsPerPixel + 7) / 8);

    public static PngHeader Parse(ReadOnlySpan<byte> data)
    {
        if (data.Length < 13)
            throw new InvalidDataException("The PNG header is too short.");
        var header = new PngHeader(
            BinaryPrimitives.ReadInt32BigEndian(data),
            BinaryPrimitives.ReadInt32BigEndian(data[4..]),
            data[8],
            (PngColorType)data[9],
            data[12] == 1);
        if (header.Width is < 1 or > LargestSide || header.Height is < 1 or > LargestSide || !header.IsAllowedDepth || data[10] != 0 || data[11] != 0 || data[12] > 1)
            throw new InvalidDataException("The PNG header is not valid.");
        return header;
    }

    private bool IsAllowedDepth => ColorType switch
    {
        PngColorType.Gray => BitDepth is 1 or 2 or 4 or 8 or 16,
        PngColorType.Palette => BitDepth is 1 or 2 or 4 or 8,
        PngColorType.TrueColor or PngColorType.GrayWithAlpha or PngColorType.TrueColorWithAlpha => BitDepth is 8 or 16,
        _ => false,
    };
}
