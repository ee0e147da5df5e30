using System.Diagnostics.CodeAnalysis;
using Engraver.Fonts;
using HarfBuzzSharp;
using Buffer = HarfBuzzSharp.Buffer;

namespace Engraver.Shaping;

/// <summary>One face of a font in HarfBuzz, for scripts whose letters join, change their order or carry stacked marks. Only this class uses the library, so
/// that it is loaded with the first such text.</summary>
[SuppressMessage("Design", "CA1001", Justification = "Faces are kept until the program ends.")]
public sealed class ShapingFace
{
    private readonly Font _font;
    private readonly Lock _guard = new();

    private ShapingFace(Func<uint, ReadOnlyMemory<byte>?> tableOf, int unitsPerEm)
    {
        var face = new Face((_, tag) => Table(tableOf, tag)) { UnitsPerEm = unitsPerEm };
        _font = new Font(face);
        _font.SetFunctionsOpenType();
        _font.SetScale(unitsPerEm, unitsPerEm);
    }

    /// <param name="tableOf">The bytes of a table of the font by its tag; null if it has none.</param>
    /// <returns>Null if the library cannot be loaded.</returns>
    public static ShapingFace? TryCreate(Func<uint, ReadOnlyMemory<byte>?> tableOf, int unitsPerEm)
    {
        try
        {
            return new ShapingFace(tableOf, unitsPerEm);
        }
        catch (Exception e) when (e is DllNotFoundException or BadImageFormatException or TypeInitializationException)
        {
            return null;
        }
    }

    /// <summary>The glyphs of a part of a text, from left to right.</summary>
    /// <param name="text">The part and what is around it: whether a letter joins can depend on one outside of the part.</param>
    /// <param name="start">Index of the first UTF-16 unit of the part; clusters are indices of the text.</param>
    public IReadOnlyList<ShapedGlyph> Shape(ReadOnlySpan<char> text, int start, int length, bool isRightToLeft, IReadOnlyList<ShapingFeature> features)
    {
        ArgumentNullException.ThrowIfNull(features);
        using var buffer = new Buffer();
        buffer.AddUtf16(text, start, length);
        buffer.GuessSegmentProperties();
        buffer.Direction = isRightToLeft ? Direction.RightToLeft : Direction.LeftToRight;
        lock (_guard) _font.Shape(buffer, [.. features.Select(feature => new Feature(Tag.Parse(feature.Tag), feature.Value, feature.Start, feature.End))]);
        var infos = buffer.GetGlyphInfoSpan();
        var positions = buffer.GetGlyphPositionSpan();
        var glyphs = new ShapedGlyph[infos.Length];
        for (var i = 0; i < glyphs.Length; i++)
        {
            var (info, position) = (infos[i], positions[i]);
            glyphs[i] = new ShapedGlyph((int)info.Codepoint, (int)info.Cluster, position.XAdvance, position.XOffset, position.YOffset);
        }

        return glyphs;
    }

    /// <summary>The memory of the table stays in place until HarfBuzz releases it. No exception may pass through the library.</summary>
    private static unsafe Blob? Table(Func<uint, ReadOnlyMemory<byte>?> tableOf, Tag tag)
    {
        try
        {
            if (tableOf(tag) is not { } table) return null;
            var pin = table.Pin();
            return new Blob((nint)pin.Pointer, table.Length, MemoryMode.ReadOnly, pin.Dispose);
        }
        catch (BrokenFontException)
        {
            return null;
        }
    }
}
