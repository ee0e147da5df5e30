using System.Diagnostics.CodeAnalysis;
using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Media.Fonts;
using Avalonia.Media.TextFormatting;
using Engraver.Fonts;
using HarfBuzzSharp;
using Buffer = HarfBuzzSharp.Buffer;
using GlyphInfo = Avalonia.Media.TextFormatting.GlyphInfo;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>One face in HarfBuzz, for scripts whose letters join, change their order or carry stacked marks. Only this class uses the library, so that it is
/// loaded with the first such text.</summary>
[SuppressMessage("Design", "CA1001", Justification = "Typefaces are kept until the program ends.")]
internal sealed class HarfBuzzFont
{
    private readonly Font _font;

    private HarfBuzzFont(SoftwareTypeface typeface)
    {
        var face = new Face((_, tag) => Table(typeface, tag)) { UnitsPerEm = typeface.UnitsPerEm };
        _font = new Font(face);
        _font.SetFunctionsOpenType();
    }

    /// <returns>Null if the library cannot be loaded.</returns>
    public static HarfBuzzFont? TryCreate(SoftwareTypeface typeface)
    {
        try
        {
            return new HarfBuzzFont(typeface);
        }
        catch (Exception e) when (e is DllNotFoundException or BadImageFormatException or TypeInitializationException)
        {
            return null;
        }
    }

    /// <summary>Adds the glyphs of a part of the text, in the order of the text.</summary>
    public void Shape(ReadOnlyMemory<char> text, ScriptRun part, in TextShaperOptions options, List<GlyphInfo> glyphs)
    {
        var isRightToLeft = (options.BidiLevel & 1) != 0;
        using var buffer = new Buffer();
        var (around, start) = Surroundings(text);
        buffer.AddUtf16(around.Span, start + part.Start, part.Length);
        buffer.GuessSegmentProperties();
        buffer.Direction = isRightToLeft ? Direction.RightToLeft : Direction.LeftToRight;
        _font.Shape(buffer, Features(options));
        _font.GetScale(out var unitsPerEm, out _);
        var scale = options.FontRenderingEmSize / unitsPerEm;
        ReadOnlySpan<HarfBuzzSharp.GlyphInfo> infos = buffer.GetGlyphInfoSpan();
        ReadOnlySpan<GlyphPosition> positions = buffer.GetGlyphPositionSpan();
        for (var i = 0; i < infos.Length; i++)
        {
            var index = isRightToLeft ? infos.Length - 1 - i : i;
            var cluster = (int)infos[index].Cluster;
            var isLastOfCluster = index + 1 == infos.Length || infos[index + 1].Cluster != infos[index].Cluster;
            var advance = positions[index].XAdvance * scale + (isLastOfCluster ? options.LetterSpacing : 0);
            var offset = new Vector(positions[index].XOffset * scale, -positions[index].YOffset * scale);
            glyphs.Add(new GlyphInfo((ushort)infos[index].Codepoint, cluster - start, advance, offset));
        }
    }

    /// <summary>The string or array that holds the text: whether a letter joins can depend on one outside of this text.</summary>
    private static (ReadOnlyMemory<char> Text, int Start) Surroundings(ReadOnlyMemory<char> text)
    {
        if (MemoryMarshal.TryGetString(text, out var whole, out var start, out _))
            return (whole.AsMemory(), start);
        return MemoryMarshal.TryGetArray(text, out var segment) ? (segment.Array, segment.Offset) : (text, 0);
    }

    private static Feature[] Features(in TextShaperOptions options) =>
        options.FontFeatures is { Count: > 0 } features
            ? [.. features.Select(feature => new Feature(Tag.Parse(feature.Tag), (uint)feature.Value, (uint)feature.Start, (uint)feature.End))]
            : [];

    /// <summary>The memory of the table stays in place until HarfBuzz releases it. No exception may pass through the library.</summary>
    private static unsafe Blob? Table(SoftwareTypeface typeface, Tag tag)
    {
        try
        {
            if (!typeface.TryGetTable(new OpenTypeTag(tag), out var table))
                return null;
            var pin = table.Pin();
            return new Blob((nint)pin.Pointer, table.Length, MemoryMode.ReadOnly, pin.Dispose);
        }
        catch (BrokenFontException)
        {
            return null;
        }
    }
}
