using System.Buffers.Binary;
using System.IO.Compression;
using Avalonia;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Bitmaps;

namespace Engraver.SoftwarePlatform.Tests.Bitmaps;

public class PngTests
{
    [Fact]
    public void What_is_written_is_read_again()
    {
        using var bitmap = new SoftwareBitmap(new PixelSize(37, 21), new Vector(144, 144), PixelFormats.Bgra8888, AlphaFormat.Unpremul);
        var random = new Random(1);
        for (var y = 0; y < 21; y++)
        {
            foreach (ref var pixel in bitmap.Row(y))
                pixel = (uint)random.NextInt64(1L << 32) | (random.Next(2) == 0 ? 0xFF000000 : 0);
        }
        using var file = new MemoryStream();
        PngFile.Write(file, bitmap);
        file.Position = 0;
        using var again = PngFile.Read(file);

        Assert.Equal(bitmap.PixelSize, again.PixelSize);
        Assert.Equal(144, again.Dpi.X, 1.0);
        for (var y = 0; y < 21; y++)
        {
            for (var x = 0; x < 37; x++)
                Assert.Equal(bitmap[x, y], again[x, y]);
        }
    }

    [Theory]
    [InlineData(2)]
    [InlineData(256)]
    public void Few_colours_are_written_by_palette_without_loss(int colours)
    {
        using var bitmap = Picture(64, 64, i => 0xFF000000 | (uint)(i % colours * 40_503));
        using var file = new MemoryStream();
        PngFile.WriteIndexed(file, bitmap);
        file.Position = 0;
        using var again = PngFile.Read(file);

        for (var y = 0; y < 64; y++) Assert.Equal(bitmap.Row(y).ToArray(), again.Row(y).ToArray());
    }

    /// <summary>A thousand greys on a background, and one red pixel: each is replaced by a similar colour, and the background is exact.</summary>
    [Fact]
    public void Many_colours_are_shown_by_near_ones()
    {
        using var bitmap = Picture(128, 128, i => i == 5001 ? 0xFFFF0000 : i % 2 == 0 ? 0xFF202830 : 0xFF000000 | (uint)((i / 2 % 1000 / 4) * 0x010101) | (uint)(i % 8));
        using var file = new MemoryStream();
        PngFile.WriteIndexed(file, bitmap);
        file.Position = 0;
        using var again = PngFile.Read(file);

        for (var i = 0; i < 128 * 128; i++)
        {
            var (wanted, shown) = (bitmap[i % 128, i / 128], again[i % 128, i / 128]);
            if (i % 2 == 0) Assert.Equal(wanted, shown);
            for (var shift = 0; shift < 24; shift += 8) Assert.InRange((int)((wanted >> shift) & 0xFF) - (int)((shown >> shift) & 0xFF), -12, 12);
        }
    }

    [Fact]
    public void A_transparent_picture_is_not_written_by_palette()
    {
        using var bitmap = Picture(4, 4, i => i == 7 ? 0x80000000 : 0xFF000000);
        using var file = new MemoryStream();

        Assert.Throws<ArgumentException>(() => PngFile.WriteIndexed(file, bitmap));
        Assert.Equal(0, file.Length);
    }

    [Theory]
    [InlineData(1, 0xFFFFFFFF, 0xFF000000)]
    [InlineData(2, 0xFFFFFFFF, 0xFFAAAAAA)]
    [InlineData(4, 0xFFFFFFFF, 0xFF999999)]
    public void Gray_of_few_bits_is_stretched_to_all_levels(int bits, uint first, uint second)
    {
        // The row's first byte: highest value, then one less than three quarters or so.
        byte row = bits switch { 1 => 0b1000_0000, 2 => 0b1110_0000, _ => 0b1111_1001 };
        using var bitmap = Read(Png(2, 1, bits, PngColorType.Gray, [0, row]));

        Assert.Equal([first, second], bitmap.Row(0).ToArray());
    }

    [Fact]
    public void A_palette_has_colors_and_transparency()
    {
        using var bitmap = Read(Png(3, 1, 8, PngColorType.Palette, [0, 2, 0, 1], ("PLTE", [255, 0, 0, 0, 255, 0, 0, 0, 255]), ("tRNS", [255, 0])));

        Assert.Equal([0xFF0000FFu, 0xFFFF0000u, 0u], bitmap.Row(0).ToArray());
    }

    [Fact]
    public void Sixteen_bits_keep_their_upper_half()
    {
        using var bitmap = Read(Png(1, 1, 16, PngColorType.TrueColorWithAlpha, [0, 0x12, 0xFF, 0x34, 0x00, 0x56, 0x80, 0xFF, 0xFF]));

        Assert.Equal(0xFF123456u, bitmap.Row(0)[0]);
    }

    [Fact]
    public void One_color_may_be_marked_as_transparent()
    {
        using var bitmap = Read(Png(2, 1, 8, PngColorType.TrueColor, [0, 1, 2, 3, 1, 2, 4], ("tRNS", [0, 1, 0, 2, 0, 3])));

        Assert.Equal([0u, 0xFF010204u], bitmap.Row(0).ToArray());
    }

    [Fact]
    public void Gray_with_alpha_is_premultiplied()
    {
        using var bitmap = Read(Png(1, 1, 8, PngColorType.GrayWithAlpha, [0, 200, 128]));

        Assert.Equal(0x80646464u, bitmap.Row(0)[0]);
    }

    [Fact]
    public void Every_row_filter_is_undone()
    {
        // Values 10 20 30 / 11 22 33 / ..., filtered by hand: none, sub, up, average, Paeth.
        byte[] rows =
        [
            0, 10, 20, 30,
            1, 11, 11, 11,
            2, 1, 2, 3,
            3, 13 - 6, 26 - (13 + 24) / 2, 39 - (26 + 36) / 2,
            4, 14 - 13, 28 - 26, 42 - 39,
        ];
        using var bitmap = Read(Png(3, 5, 8, PngColorType.Gray, rows));

        var grays = Enumerable.Range(0, 5).SelectMany(y => bitmap.Row(y).ToArray().Select(pixel => (int)(pixel & 255)));
        Assert.Equal([10, 20, 30, 11, 22, 33, 12, 24, 36, 13, 26, 39, 14, 28, 42], grays);
    }

    [Fact]
    public void An_interlaced_image_of_any_size_is_put_together()
    {
        // 3 x 3 in seven passes; pass 2 and others have no pixels at this size.
        byte[] passes = [0, 1, 0, 3, 0, 7, 9, 0, 2, 0, 8, 0, 4, 5, 6];
        using var bitmap = Read(Png(3, 3, 8, PngColorType.Gray, passes, isInterlaced: true));

        var grays = Enumerable.Range(0, 3).SelectMany(y => bitmap.Row(y).ToArray().Select(pixel => (int)(pixel & 255)));
        Assert.Equal([1, 2, 3, 4, 5, 6, 7, 8, 9], grays);
    }

    /// <summary>Data in several chunks is one stream; unknown chunks are skipped.</summary>
    [Fact]
    public void Chunks_that_are_not_known_are_passed_over()
    {
        using var bitmap = Read(Png(2, 1, 8, PngColorType.Gray, [0, 7, 9], ("tEXt", [.. "Comment\0none"u8]), ("gAMA", [0, 0, 177, 143])));

        Assert.Equal([0xFF070707u, 0xFF090909u], bitmap.Row(0).ToArray());
    }

    [Fact]
    public void Broken_files_are_refused_by_name()
    {
        var good = Png(3, 3, 8, PngColorType.Gray, [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3]);

        Assert.Throws<InvalidDataException>(() => Read([0xFF, 0xD8, 0xFF, 0xE0, 0, 0, 0, 0, 0, 0]));
        Assert.Throws<InvalidDataException>(() => Read(good[..40]));
        Assert.Throws<InvalidDataException>(() => Read(Png(3, 3, 8, PngColorType.Gray, [0, 1, 2, 3])));
        Assert.Throws<InvalidDataException>(() => Read(Png(3, 1, 3, PngColorType.Gray, [0, 1, 2, 3])));
        Assert.Throws<InvalidDataException>(() => Read(Png(1, 1, 8, PngColorType.Palette, [0, 7], ("PLTE", [1, 2, 3]))));
        Assert.Throws<InvalidDataException>(() => Read(Png(1, 1, 8, PngColorType.Gray, [9, 1])));
    }

    private static SoftwareBitmap Read(byte[] file)
    {
        using var stream = new MemoryStream(file);
        return PngFile.Read(stream);
    }

    private static byte[] Png(int width, int height, int bits, PngColorType type, byte[] rows, params (string Name, byte[] Data)[] chunks) =>
        Png(width, height, bits, type, rows, false, chunks);

    private static byte[] Png(int width, int height, int bits, PngColorType type, byte[] rows, bool isInterlaced, params (string Name, byte[] Data)[] chunks)
    {
        using var file = new MemoryStream();
        file.Write(PngChunk.Signature);
        var header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        (header[8], header[9], header[12]) = ((byte)bits, (byte)type, (byte)(isInterlaced ? 1 : 0));
        PngChunk.Write(file, "IHDR"u8, header);
        foreach (var (name, data) in chunks)
            PngChunk.Write(file, System.Text.Encoding.ASCII.GetBytes(name), data);
        using var compressed = new MemoryStream();
        using (var compressor = new ZLibStream(compressed, CompressionLevel.Optimal, leaveOpen: true))
            compressor.Write(rows);
        var packed = compressed.ToArray();
        PngChunk.Write(file, "IDAT"u8, packed.AsSpan(0, packed.Length / 2));
        PngChunk.Write(file, "IDAT"u8, packed.AsSpan(packed.Length / 2));
        PngChunk.Write(file, "IEND"u8, []);
        return file.ToArray();
    }

    private static SoftwareBitmap Picture(int width, int height, Func<int, uint> pixel)
    {
        var bitmap = new SoftwareBitmap(new PixelSize(width, height), new Vector(96, 96));
        for (var i = 0; i < width * height; i++) bitmap.Row(i / width)[i % width] = pixel(i);
        return bitmap;
    }
}
