using System.Collections.Concurrent;
using System.Diagnostics.CodeAnalysis;
using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Fonts;
using Engraver.Fonts;
using Engraver.Fonts.OpenType;
using Engraver.Fonts.OpenType.Outlines;
using Engraver.SoftwarePlatform.Rasteriser.Paths;
using FontStyle = Avalonia.Media.FontStyle;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>A face with its outlines, kerning and drawn glyphs.</summary>
internal sealed class SoftwareTypeface : IPlatformTypeface
{
    private const uint CharacterMapTag = 0x636D6170;

    /// <summary>Slant that replaces a missing italic.</summary>
    private const double ObliqueSlant = 0.25;

    /// <summary>Part of the font size by which a synthetic bold is wider to the right.</summary>
    private const double BoldGrowth = 1.0 / 24;

    private readonly FontFile _file;
    private readonly Lazy<IGlyphOutlines> _outlines;
    private readonly Lazy<TypefaceKerning> _kerning;
    private readonly Lazy<MarkPlacement> _marks;
    private readonly Lazy<HarfBuzzFont?> _harfBuzz;
    private readonly ConcurrentDictionary<int, VectorPath> _paths = new();

    private SoftwareTypeface(FontFile file, FontSimulations simulations)
    {
        _file = file;
        FontSimulations = simulations;
        UnitsPerEm = Math.Max(16, (int)file.Table("head").UInt16(18));
        _outlines = new Lazy<IGlyphOutlines>(() => GlyphOutlines.Read(file));
        _kerning = new Lazy<TypefaceKerning>(() => new TypefaceKerning(file));
        _marks = new Lazy<MarkPlacement>(() => MarkPlacement.Read(file));
        _harfBuzz = new Lazy<HarfBuzzFont?>(() => HarfBuzzFont.TryCreate(this));
        Masks = new GlyphMasks(this);
        GlyphTypeface = new GlyphTypeface(this);
        Characters = new CharacterTable(GlyphTypeface);
        Validate(GlyphTypeface, file);
        FamilyName = GlyphTypeface.FamilyName;
        Weight = GlyphTypeface.Weight;
        Style = GlyphTypeface.Style;
        Stretch = GlyphTypeface.Stretch;
    }

    /// <summary>Avalonia's reader of the character map, the names and the metrics.</summary>
    public GlyphTypeface GlyphTypeface { get; }

    public string FamilyName { get; } = "";

    public FontWeight Weight { get; } = FontWeight.Normal;

    public FontStyle Style { get; }

    public FontStretch Stretch { get; } = FontStretch.Normal;

    public FontSimulations FontSimulations { get; }

    public int UnitsPerEm { get; }

    public GlyphMasks Masks { get; }

    public CharacterTable Characters { get; }

    public TypefaceKerning Kerning => _kerning.Value;

    public MarkPlacement Marks => _marks.Value;

    /// <summary>Null if the library is not installed.</summary>
    public HarfBuzzFont? HarfBuzz => _harfBuzz.Value;

    /// <returns>Null for a font that cannot be used: broken, or without outlines.</returns>
    public static SoftwareTypeface? TryCreate(IFontSource source, int face, FontSimulations simulations)
    {
        try
        {
            var file = new FontFile(source, face);
            return GlyphOutlines.IsIn(file) ? new SoftwareTypeface(file, simulations) : null;
        }
        catch (Exception e) when (IsFontFault(e))
        {
            return null;
        }
    }

    public SoftwareTypeface? TrySimulate(FontSimulations simulations)
    {
        try
        {
            return new SoftwareTypeface(_file, simulations);
        }
        catch (Exception e) when (IsFontFault(e))
        {
            return null;
        }
    }

    public bool TryGetStream([NotNullWhen(true)] out Stream? stream)
    {
        stream = new MemoryStream(_file.WholeFile().ToArray(), writable: false);
        return true;
    }

    public bool TryGetTable(OpenTypeTag tag, out ReadOnlyMemory<byte> table)
    {
        if (!_file.TryGetTable((uint)tag, out table))
            return false;
        if ((uint)tag == CharacterMapTag)
            table = CharacterMapUpgrade.Upgrade(table);
        return true;
    }

    /// <summary>In font units, y up; empty for a glyph that is blank or broken.</summary>
    public VectorPath Outline(int glyph) => _paths.GetOrAdd(glyph, MakeOutline);

    /// <summary>From font units, y up, to pixels, y down.</summary>
    public Matrix GlyphTransform(double pixelsPerEm)
    {
        var scale = pixelsPerEm / UnitsPerEm;
        var slant = FontSimulations.HasFlag(FontSimulations.Oblique) ? ObliqueSlant * scale : 0;
        return new Matrix(scale, 0, slant, -scale, 0, 0);
    }

    public void Dispose()
    {
    }

    /// <summary>Reads some characters and widths immediately, because Avalonia's reader detects broken tables only then, and during drawing it would be too
    /// late.</summary>
    private static void Validate(GlyphTypeface typeface, FontFile file)
    {
        foreach (var character in (ReadOnlySpan<int>)[' ', 'A', 0x4E2D, 0xFFFF, 0x1F600])
            _ = typeface.CharacterToGlyphMap[character];
        foreach (var glyph in (ReadOnlySpan<int>)[0, Math.Max(0, file.Table("maxp").UInt16(4) - 1)])
            _ = typeface.TryGetHorizontalGlyphAdvance((ushort)glyph, out _);
    }

    private VectorPath MakeOutline(int glyph)
    {
        try
        {
            var path = new VectorPath(FillRule.NonZero);
            _outlines.Value.Draw(glyph, new PathSink(path));
            return FontSimulations.HasFlag(FontSimulations.Bold) ? Bold(path) : path;
        }
        catch (BrokenFontException)
        {
            return new VectorPath(FillRule.NonZero);
        }
    }

    /// <summary>The shape and a copy a little to the right, both with the same winding, so that together they are filled as one.</summary>
    private VectorPath Bold(VectorPath path)
    {
        var wide = path.Transformed(Matrix.Identity);
        wide.Append(path, Matrix.CreateTranslation(BoldGrowth * UnitsPerEm, 0));
        return wide;
    }

    /// <summary>True for the exceptions that Avalonia's and this reader throw for files that are not valid fonts.</summary>
    private static bool IsFontFault(Exception e) =>
        e is BrokenFontException or InvalidOperationException or ArgumentException or IndexOutOfRangeException or NotSupportedException
            or IOException or OverflowException or KeyNotFoundException or FormatException or InvalidDataException;
}
