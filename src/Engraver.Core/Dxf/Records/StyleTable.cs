using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Records;

/// <summary>The text styles of the STYLE table.</summary>
internal sealed class StyleTable
{
    private const int VerticalFlag = 4;

    private readonly Dictionary<string, TextStyle> _byName = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<TextStyle> _styles = [];

    /// <summary>Takes a STYLE entry (DXF reference, "STYLE"). Entries without a name are shape files, not text styles; of two with one name the first
    /// counts.</summary>
    public void Define(EntityRecord entry)
    {
        if (entry.TextOf(2) is not { Length: > 0 } name || _byName.ContainsKey(name)) return;
        var style = new TextStyle(name)
        {
            FontFile = entry.TextOf(3),
            BigFontFile = entry.TextOf(4),
            FixedHeight = entry.First(40, 0.0),
            WidthFactor = entry.First(41, 1.0),
            Oblique = Angle.FromDegrees(entry.First(50, 0.0)),
            Generation = (TextGeneration)(entry.FirstFlags(71) & (int)(TextGeneration.Backwards | TextGeneration.UpsideDown)),
            IsVertical = (entry.FirstFlags(70) & VerticalFlag) != 0,
        };
        foreach (var value in entry.ExtendedOf("ACAD"))
        {
            if (value.Code == 1000 && style.Family.Length == 0) style = style with { Family = value.Text };
            else if (value.Code == 1071) style = style with { FamilyFlags = value.Whole };
        }

        _byName.Add(name, style);
        _styles.Add(style);
    }

    /// <summary>Font file of a style; "" when it is not known.</summary>
    public string FontOf(string style) => _byName.TryGetValue(style, out var known) ? known.FontFile : "";

    public IReadOnlyList<TextStyle> ToStyles() => _styles;
}
