using System.Globalization;
using System.Runtime.InteropServices;
using Avalonia;
using Engraver.SoftwarePlatform.Bitmaps;

namespace Engraver.App.Tests.Canvas.Rasterising;

/// <summary>A picture that was looked at before it was committed, with which a window's picture is compared pixel by pixel.</summary>
/// <param name="path">Its PNG file.</param>
/// <param name="output">Folder for what differs from it.</param>
internal sealed class ReviewedPicture(string path, string output)
{
    private const uint Differs = 0xFF_FF_00_00;

    private string Name => Path.GetFileNameWithoutExtension(path);

    /// <summary>Compares a picture with it.</summary>
    /// <param name="png">As it is committed: with one byte for a pixel.</param>
    /// <returns>Null when every pixel has the same colour; otherwise the difference.</returns>
    public PictureDifference? Compare(byte[] png)
    {
        if (!File.Exists(path)) return new PictureDifference("There is no such picture yet.", null);
        var (actual, reviewed) = (Pixels.Read(png), Pixels.Read(File.ReadAllBytes(path)));
        if (actual.Size != reviewed.Size) return new PictureDifference(string.Create(CultureInfo.InvariantCulture, $"It has {actual.Size.Width} x {actual.Size.Height} pixels, the reviewed one {reviewed.Size.Width} x {reviewed.Size.Height}."), null);
        var shown = new uint[actual.Colours.Length];
        var (count, box) = (0, default(PixelRect));
        for (var i = 0; i < shown.Length; i++)
        {
            if (actual.Colours[i] == reviewed.Colours[i])
            {
                shown[i] = Faint(actual.Colours[i]);
                continue;
            }

            var at = new PixelPoint(i % actual.Size.Width, i / actual.Size.Width);
            shown[i] = Differs;
            var pixel = new PixelRect(at, new PixelSize(1, 1));
            box = count++ == 0 ? pixel : box.Union(pixel);
        }

        return count == 0 ? null : new PictureDifference(string.Create(CultureInfo.InvariantCulture, $"{count} pixels differ, between {box.X},{box.Y} and {box.Right - 1},{box.Bottom - 1}."), new Pixels(actual.Size, shown));
    }

    /// <summary>Writes the picture and where it differs.</summary>
    /// <returns>What is wrong and where to look.</returns>
    public string Keep(byte[] png, PictureDifference difference)
    {
        Directory.CreateDirectory(output);
        var (actual, differing) = (Path.Combine(output, Name + ".actual.png"), Path.Combine(output, Name + ".difference.png"));
        File.WriteAllBytes(actual, png);
        if (difference.Picture is { } picture) File.WriteAllBytes(differing, picture.ToPng());
        return $"The picture {Name} differs from {path}. {difference.Sentence} See {actual}{(difference.Picture is null ? "" : $" and {differing}")}. If it is right, look at it and run ./test --update-golden.";
    }

    /// <summary>Replaces the reviewed picture, unless the new one has the same colours.</summary>
    public void Replace(byte[] png)
    {
        if (Compare(png) is not null) File.WriteAllBytes(path, png);
    }

    /// <summary>Grey and light, so that what differs is seen.</summary>
    private static uint Faint(uint colour)
    {
        var grey = 0xC0 + (((colour & 0xFF) + ((colour >> 8) & 0xFF) + ((colour >> 16) & 0xFF)) / 12);
        return 0xFF000000 | (grey << 16) | (grey << 8) | grey;
    }
}

/// <summary>In what a picture differs from the reviewed one.</summary>
/// <param name="Picture">Red where they differ; null where they cannot be compared.</param>
internal sealed record PictureDifference(string Sentence, Pixels? Picture);

/// <summary>Colours row by row: alpha, red, green, blue from the highest byte on.</summary>
internal sealed record Pixels(PixelSize Size, uint[] Colours)
{
    public static Pixels Read(byte[] png)
    {
        using var stream = new MemoryStream(png);
        using var bitmap = PngFile.Read(stream);
        using var locked = bitmap.Lock();
        var colours = new int[bitmap.PixelSize.Width * bitmap.PixelSize.Height];
        Marshal.Copy(locked.Address, colours, 0, colours.Length);
        return new Pixels(bitmap.PixelSize, [.. colours.Select(colour => unchecked((uint)colour))]);
    }

    public byte[] ToPng()
    {
        using var bitmap = new SoftwareBitmap(Size, new Vector(96, 96));
        using (var locked = bitmap.Lock()) Marshal.Copy([.. Colours.Select(colour => unchecked((int)colour))], 0, locked.Address, Colours.Length);
        using var stream = new MemoryStream();
        PngFile.Write(stream, bitmap);
        return stream.ToArray();
    }
}
