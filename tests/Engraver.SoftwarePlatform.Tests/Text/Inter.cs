using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Text;

namespace Engraver.SoftwarePlatform.Tests.Text;

/// <summary>The font that comes with the program, read without an application.</summary>
internal static class Inter
{
    private static readonly Lazy<SoftwareTypeface> s_regular = new(() => Load("Inter-Regular"));

    public static SoftwareTypeface Regular => s_regular.Value;

    public static ShapedBuffer Shape(string text, double size = 16, sbyte bidiLevel = 0, double letterSpacing = 0, double tabWidth = 0) =>
        new SoftwareTextShaper().ShapeText(text.AsMemory(), new TextShaperOptions(Regular.GlyphTypeface, size, bidiLevel, null, tabWidth, letterSpacing));

    public static IGlyphRunImpl Run(string text, double size, double x, double y) =>
        Drawing.Picture.Platform.CreateGlyphRun(Regular.GlyphTypeface, size, [.. Shape(text, size)], new Avalonia.Point(x, y));

    private static SoftwareTypeface Load(string name)
    {
        using var stream = new StandardAssetLoader().Open(new Uri($"avares://Avalonia.Fonts.Inter/Assets/{name}.ttf"));
        Assert.True(new SoftwareFontManager([]).TryCreateGlyphTypeface(stream, FontSimulations.None, out var typeface));
        return (SoftwareTypeface)typeface;
    }
}
