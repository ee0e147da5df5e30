using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf.Text;

/// <summary>Converts TEXT, MTEXT, ATTRIB and constant ATTDEF into placed texts, in world coordinates (inside a block: the block's).</summary>
internal sealed class TextMapper(StyleTable styles)
{
    private const string StandardStyle = "STANDARD";
    private const int HiddenAttribute = 1;
    private const int ConstantAttribute = 2;

    /// <summary>The text of a record; null when it is empty or out of range.</summary>
    public PlacedText? Map(EntityRecord record)
    {
        var text = Text(record, record.Type == "MTEXT" ? WrittenTexts.OfMText(record) : WrittenTexts.OfText(record, IsAttribute(record)));
        return text.Content.Length > 0 && PlacedTexts.IsInRange(text) ? text : null;
    }

    /// <summary>The text of a constant ATTDEF, which every copy of its block shows; null for any other ATTDEF.</summary>
    public PlacedText? MapConstant(EntityRecord record) => ((int)record.First(70, 0.0) & ConstantAttribute) != 0 ? Map(record) : null;

    private static bool IsAttribute(EntityRecord record) => record.Kind is RecordKind.Attribute or RecordKind.AttributeDefinition;

    private PlacedText Text(EntityRecord record, WrittenText written)
    {
        var style = record.TextOf(7) is { Length: > 0 } named ? named : StandardStyle;
        return TextSummary.Derived(new PlacedText
        {
            Type = record.Type,
            Written = written,
            Content = "",
            Position = default,
            Height = 0.0,
            Rotation = default,
            Style = style,
            Font = styles.FontOf(style),
            Colour = record.Colour,
            Lineweight = record.Lineweight ?? Lineweight.ByLayer,
            Layer = record.Layer,
            Handle = record.Handle,
            SourceLine = record.Line,
            Hidden = record.Invisible || (IsAttribute(record) && ((int)record.First(70, 0.0) & HiddenAttribute) != 0),
        });
    }
}
