using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Media.Fonts;
using Avalonia.Media.TextFormatting;
using Engraver.Shaping;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>One typeface for scripts whose letters join, change their order or carry stacked marks.</summary>
internal sealed class HarfBuzzFont
{
    private readonly ShapingFace _face;
    private readonly int _unitsPerEm;

    private HarfBuzzFont(ShapingFace face, int unitsPerEm) => (_face, _unitsPerEm) = (face, unitsPerEm);

    /// <returns>Null if the library cannot be loaded.</returns>
    public static HarfBuzzFont? TryCreate(SoftwareTypeface typeface) =>
        ShapingFace.TryCreate(tag => typeface.TryGetTable(new OpenTypeTag(tag), out var table) ? table : null, typeface.UnitsPerEm) is { } face ? new HarfBuzzFont(face, typeface.UnitsPerEm) : null;

    /// <summary>Adds the glyphs of a part of the text, in the order of the text.</summary>
    public void Shape(ReadOnlyMemory<char> text, ScriptRun part, in TextShaperOptions options, List<GlyphInfo> glyphs)
    {
        var isRightToLeft = (options.BidiLevel & 1) != 0;
        var (around, start) = Surroundings(text);
        var shaped = _face.Shape(around.Span, start + part.Start, part.Length, isRightToLeft, Features(options));
        var scale = options.FontRenderingEmSize / _unitsPerEm;
        for (var i = 0; i < shaped.Count; i++)
        {
            var index = isRightToLeft ? shaped.Count - 1 - i : i;
            var glyph = shaped[index];
            var isLastOfCluster = index + 1 == shaped.Count || shaped[index + 1].Cluster != glyph.Cluster;
            var advance = glyph.Advance * scale + (isLastOfCluster ? options.LetterSpacing : 0);
            glyphs.Add(new GlyphInfo((ushort)glyph.Glyph, glyph.Cluster - start, advance, new Vector(glyph.XOffset * scale, -glyph.YOffset * scale)));
        }
    }

    /// <summary>The string or array that holds the text: whether a letter joins can depend on one outside of this text.</summary>
    private static (ReadOnlyMemory<char> Text, int Start) Surroundings(ReadOnlyMemory<char> text)
    {
        if (MemoryMarshal.TryGetString(text, out var whole, out var start, out _))
            return (whole.AsMemory(), start);
        return MemoryMarshal.TryGetArray(text, out var segment) ? (segment.Array, segment.Offset) : (text, 0);
    }

    private static ShapingFeature[] Features(in TextShaperOptions options) =>
        options.FontFeatures is { Count: > 0 } features
            ? [.. features.Select(feature => new ShapingFeature(feature.Tag, (uint)feature.Value, (uint)feature.Start, (uint)feature.End))]
            : [];
}
