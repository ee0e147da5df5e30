using Avalonia;
using Avalonia.Media.Imaging;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Rasteriser;
using Engraver.SoftwarePlatform.Rasteriser.Paints;

namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Pixels in memory: a bitmap to show and to write into. One that is drawn on is a DrawableBitmap.</summary>
/// <remarks>Stored in the format asked for (blue or red first; colours premultiplied, plain, or alpha ignored); a bitmap that is drawn on is always
/// premultiplied with blue first.</remarks>
public unsafe class SoftwareBitmap : IWriteableBitmapImpl
{
    private readonly PixelMemory _memory;
    private readonly PixelFormat _format;
    private readonly AlphaFormat _alphaFormat;
    private DerivedBitmaps? _derived;

    public SoftwareBitmap(PixelSize size, Vector dpi)
        : this(size, dpi, PixelFormats.Bgra8888, Avalonia.Platform.AlphaFormat.Premul)
    {
    }

    public SoftwareBitmap(PixelSize size, Vector dpi, PixelFormat format, AlphaFormat alphaFormat)
    {
        if (format != PixelFormats.Bgra8888 && format != PixelFormats.Rgba8888)
            throw new NotSupportedException("Bitmaps are stored with 8 bits for each of blue, green, red and alpha.");
        PixelSize = new PixelSize(Math.Max(1, size.Width), Math.Max(1, size.Height));
        Dpi = dpi;
        _format = format;
        _alphaFormat = alphaFormat;
        _memory = new PixelMemory((long)PixelSize.Width * PixelSize.Height);
    }

    public Vector Dpi { get; }

    public PixelSize PixelSize { get; }

    /// <summary>Increases with each change.</summary>
    public int Version { get; private set; } = 1;

    public PixelFormat? Format => _format;

    public AlphaFormat? AlphaFormat => _alphaFormat;

    /// <summary>First pixel; rows follow each other without gaps.</summary>
    internal uint* Pixels => _memory.Pixels;

    internal Span<uint> Row(int y) => new(Pixels + (long)y * PixelSize.Width, PixelSize.Width);

    internal PixelBounds Bounds => new(0, 0, PixelSize.Width, PixelSize.Height);

    internal bool IsOpaqueFormat => _alphaFormat == Avalonia.Platform.AlphaFormat.Opaque;

    /// <summary>True when <see cref="PixelSource"/> can read it without conversion.</summary>
    internal bool IsDirectlyReadable => _format == PixelFormats.Bgra8888 && _alphaFormat != Avalonia.Platform.AlphaFormat.Unpremul;

    internal PixelSource Source => new(Pixels, PixelSize.Width, PixelSize.Width, PixelSize.Height, IsOpaqueFormat ? 0xFF000000 : 0);

    /// <summary>A pixel, premultiplied with blue first, whatever the storage format.</summary>
    internal uint this[int x, int y] => Converted(Row(y)[x]);

    public ILockedFramebuffer Lock() =>
        new LockedFramebuffer((IntPtr)Pixels, PixelSize, PixelSize.Width * 4, Dpi, _format, _alphaFormat, Changed);

    public void Save(Stream stream, BitmapEncoderOptions options) => PngFile.Write(stream, this);

    public void Dispose()
    {
        _derived?.Dispose();
        _derived = null;
        _memory.Dispose();
        GC.SuppressFinalize(this);
    }

    /// <summary>This bitmap, or a cached copy, in a directly readable format and halved as often as asked.</summary>
    /// <param name="halvings">How often its sides are halved, averaging.</param>
    internal SoftwareBitmap ForReading(int halvings)
    {
        if (halvings == 0 && IsDirectlyReadable)
            return this;
        if (_derived is null || _derived.Version != Version)
        {
            _derived?.Dispose();
            _derived = new DerivedBitmaps(this);
        }
        return _derived.Get(halvings);
    }

    internal uint Converted(uint pixel)
    {
        var blueFirst = _format == PixelFormats.Rgba8888 ? PixelArithmetic.Swapped(pixel) : pixel;
        return _alphaFormat switch
        {
            Avalonia.Platform.AlphaFormat.Opaque => blueFirst | 0xFF000000,
            Avalonia.Platform.AlphaFormat.Unpremul => PixelArithmetic.Premultiplied(blueFirst),
            _ => blueFirst,
        };
    }

    internal void Changed() => Version++;
}
