using Engraver.Fonts;
using Engraver.Fonts.OpenType;
using Engraver.Fonts.OpenType.Layout;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>The pair kerning of a typeface, with the last pairs kept. Pairs that the font describes wrongly are not kerned.</summary>
internal sealed class TypefaceKerning(FontFile file)
{
    private readonly PairKerning _pairs = Read(file);
    private readonly KerningCache _known = new();

    /// <summary>Font units to add to the advance of <paramref name="first"/>; the glyphs are given from left to right.</summary>
    public int Between(int first, int second)
    {
        if (_pairs.IsEmpty)
            return 0;
        if (!_known.TryGet(first, second, out var units))
        {
            units = Find(first, second);
            _known.Keep(first, second, units);
        }
        return units;
    }

    private int Find(int first, int second)
    {
        try
        {
            return _pairs.Between(first, second);
        }
        catch (BrokenFontException)
        {
            return 0;
        }
    }

    private static PairKerning Read(FontFile file)
    {
        try
        {
            return PairKerning.Read(file);
        }
        catch (BrokenFontException)
        {
            return PairKerning.None;
        }
    }
}
