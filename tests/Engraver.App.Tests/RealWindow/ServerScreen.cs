using System.Buffers.Binary;
using System.Runtime.InteropServices;
using Avalonia;
using Engraver.SoftwarePlatform.Bitmaps;

namespace Engraver.App.Tests.RealWindow;

/// <summary>The contents of the X server's screen: its frame buffer file, an X window dump of 32 bits per pixel.</summary>
internal sealed class ServerScreen
{
    private const int HeaderSizeAt = 0;
    private const int WidthAt = 16;
    private const int HeightAt = 20;
    private const int LineBytesAt = 48;
    private const int ColourCountAt = 76;
    private const int ColourBytes = 12;
    private readonly byte[] _dump;
    private readonly int _pixels;
    private readonly int _lineBytes;

    /// <param name="folder">The screen folder of the server.</param>
    public ServerScreen(string folder)
    {
        using var file = new FileStream(Path.Combine(folder, "Xvfb_screen0"), FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        _dump = new byte[file.Length];
        file.ReadExactly(_dump);
        _pixels = Number(HeaderSizeAt) + (Number(ColourCountAt) * ColourBytes);
        _lineBytes = Number(LineBytesAt);
        (Width, Height) = (Number(WidthAt), Number(HeightAt));
    }

    public int Width { get; }

    public int Height { get; }

    /// <summary>0xRRGGBB.</summary>
    public int At(int x, int y) => BinaryPrimitives.ReadInt32LittleEndian(_dump.AsSpan(_pixels + (y * _lineBytes) + (x * sizeof(int)))) & 0xFFFFFF;

    /// <summary>Writes a rectangle as an indexed picture, if it has few enough colours.</summary>
    public byte[] Png(PixelRect part)
    {
        using var picture = new SoftwareBitmap(part.Size, new Vector(96, 96));
        using (var pixels = picture.Lock())
        {
            var row = new int[part.Width];
            for (var y = 0; y < part.Height; y++)
            {
                for (var x = 0; x < part.Width; x++) row[x] = At(part.X + x, part.Y + y) | unchecked((int)0xFF000000);
                Marshal.Copy(row, 0, pixels.Address + (y * pixels.RowBytes), row.Length);
            }
        }

        using var file = new MemoryStream();
        PngFile.WriteIndexed(file, picture);
        return file.ToArray();
    }

    /// <summary>Whether a rectangle contains given pixels.</summary>
    /// <param name="look">0xRRGGBB, row by row.</param>
    public bool Shows(PixelRect place, int[] look)
    {
        for (var i = 0; i < look.Length; i++)
        {
            if (At(place.X + (i % place.Width), place.Y + (i / place.Width)) != look[i]) return false;
        }

        return true;
    }

    /// <summary>Equal in every pixel.</summary>
    public bool Equals(ServerScreen other) => _dump.AsSpan().SequenceEqual(other._dump);

    /// <summary>Number of pixels of a rectangle that differ from its first pixel.</summary>
    public int Drawn(int left, int top, int width, int height)
    {
        var drawn = 0;
        for (var y = top; y < top + height; y++)
        {
            for (var x = left; x < left + width; x++)
            {
                if (At(x, y) != At(left, top)) drawn++;
            }
        }

        return drawn;
    }

    private int Number(int at) => BinaryPrimitives.ReadInt32BigEndian(_dump.AsSpan(at));
}
