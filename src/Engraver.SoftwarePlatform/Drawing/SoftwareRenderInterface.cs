using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Bitmaps;
using Engraver.SoftwarePlatform.Geometry;
using Engraver.SoftwarePlatform.Rasteriser.Paths;
using Engraver.SoftwarePlatform.Text;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>Makes everything that Avalonia draws with or on. Has no state itself.</summary>
public sealed unsafe class SoftwareRenderInterface : IPlatformRenderInterface
{
    public bool SupportsIndividualRoundRects => true;

    public AlphaFormat DefaultAlphaFormat => AlphaFormat.Premul;

    public PixelFormat DefaultPixelFormat => PixelFormats.Bgra8888;

    /// <summary>True: several dirty rectangles become a clip of several rectangles.</summary>
    public bool SupportsRegions => true;

    public bool IsSupportedBitmapPixelFormat(PixelFormat format) => format == PixelFormats.Bgra8888 || format == PixelFormats.Rgba8888;

    public IPlatformRenderInterfaceRegion CreateRegion() => new SoftwareRegion();

    public IPlatformRenderInterfaceContext CreateBackendContext(IPlatformGraphicsContext? graphicsApiContext) => new SoftwareRenderContext();

    public IGeometryImpl CreateEllipseGeometry(Rect rect)
    {
        var path = new VectorPath(FillRule.NonZero);
        path.AddEllipse(rect);
        return new SoftwareGeometry(path);
    }

    public IGeometryImpl CreateLineGeometry(Point p1, Point p2)
    {
        var path = new VectorPath();
        path.MoveTo(p1);
        path.LineTo(p2);
        return new SoftwareGeometry(path);
    }

    public IGeometryImpl CreateRectangleGeometry(Rect rect)
    {
        var path = new VectorPath(FillRule.NonZero);
        path.AddRectangle(rect);
        return new SoftwareGeometry(path);
    }

    public IStreamGeometryImpl CreateStreamGeometry() => new SoftwareStreamGeometry();

    public IGeometryImpl CreateGeometryGroup(FillRule fillRule, IReadOnlyList<IGeometryImpl> children)
    {
        ArgumentNullException.ThrowIfNull(children);
        VectorPath stroke = new(fillRule), fill = new(fillRule);
        foreach (var child in children.OfType<SoftwareGeometry>())
        {
            stroke.Append(child.StrokePath, Matrix.Identity);
            fill.Append(child.FillPath, Matrix.Identity);
        }
        return new SoftwareGeometry(stroke, fill);
    }

    public IGeometryImpl CreateCombinedGeometry(GeometryCombineMode combineMode, IGeometryImpl g1, IGeometryImpl g2) =>
        new SoftwareGeometry(PathCombination.Combine(((SoftwareGeometry)g1).FillPath, ((SoftwareGeometry)g2).FillPath, combineMode));

    public IGeometryImpl BuildGlyphRunGeometry(GlyphRun glyphRun)
    {
        ArgumentNullException.ThrowIfNull(glyphRun);
        using var run = new SoftwareGlyphRun(glyphRun.GlyphTypeface, glyphRun.FontRenderingEmSize, glyphRun.GlyphInfos, glyphRun.BaselineOrigin);
        return new SoftwareGeometry(run.Outline);
    }

    public IGlyphRunImpl CreateGlyphRun(GlyphTypeface glyphTypeface, double fontRenderingEmSize, IReadOnlyList<GlyphInfo> glyphInfos, Point baselineOrigin) =>
        new SoftwareGlyphRun(glyphTypeface, fontRenderingEmSize, glyphInfos, baselineOrigin);

    public IRenderTargetBitmapImpl CreateRenderTargetBitmap(PixelSize size, Vector dpi) => new DrawableBitmap(size, dpi);

    public IWriteableBitmapImpl CreateWriteableBitmap(PixelSize size, Vector dpi, PixelFormat format, AlphaFormat alphaFormat) =>
        new SoftwareBitmap(size, dpi, format, alphaFormat);

    public IBitmapImpl LoadBitmap(string fileName) => Load(fileName);

    public IBitmapImpl LoadBitmap(Stream stream) => PngFile.Read(stream);

    public IWriteableBitmapImpl LoadWriteableBitmap(string fileName) => Load(fileName);

    public IWriteableBitmapImpl LoadWriteableBitmap(Stream stream) => PngFile.Read(stream);

    public IBitmapImpl LoadBitmapToWidth(Stream stream, int width, BitmapInterpolationMode interpolationMode) => Load(stream, width, 0, interpolationMode);

    public IBitmapImpl LoadBitmapToHeight(Stream stream, int height, BitmapInterpolationMode interpolationMode) => Load(stream, 0, height, interpolationMode);

    public IWriteableBitmapImpl LoadWriteableBitmapToWidth(Stream stream, int width, BitmapInterpolationMode interpolationMode) =>
        Load(stream, width, 0, interpolationMode);

    public IWriteableBitmapImpl LoadWriteableBitmapToHeight(Stream stream, int height, BitmapInterpolationMode interpolationMode) =>
        Load(stream, 0, height, interpolationMode);

    public IBitmapImpl ResizeBitmap(IBitmapImpl bitmapImpl, PixelSize destinationSize, BitmapInterpolationMode interpolationMode) =>
        BitmapScaling.Resized((SoftwareBitmap)bitmapImpl, destinationSize, interpolationMode != BitmapInterpolationMode.None);

    public IBitmapImpl LoadBitmap(PixelFormat format, AlphaFormat alphaFormat, IntPtr data, PixelSize size, Vector dpi, int stride)
    {
        var bitmap = new SoftwareBitmap(size, dpi, format, alphaFormat);
        for (var y = 0; y < size.Height; y++)
            new ReadOnlySpan<uint>((byte*)data + (long)y * stride, size.Width).CopyTo(bitmap.Row(y));
        return bitmap;
    }

    private static SoftwareBitmap Load(string fileName)
    {
        using var stream = File.OpenRead(fileName);
        return PngFile.Read(stream);
    }

    /// <summary>Loads an image; a side given as 0 follows from the other one.</summary>
    private static SoftwareBitmap Load(Stream stream, int width, int height, BitmapInterpolationMode mode)
    {
        using var whole = PngFile.Read(stream);
        var size = whole.PixelSize;
        var wanted = width > 0
            ? new PixelSize(width, Math.Max(1, (int)((long)width * size.Height / size.Width)))
            : new PixelSize(Math.Max(1, (int)((long)height * size.Width / size.Height)), height);
        return BitmapScaling.Resized(whole, wanted, mode != BitmapInterpolationMode.None);
    }
}
