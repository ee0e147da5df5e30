using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Text;

/// <summary>Converts TEXT, MTEXT, ATTRIB and constant ATTDEF into placed texts, in world coordinates (inside a block: the block's).</summary>
internal sealed class TextMapper(StyleTable styles)
{
    private const string StandardStyle = "STANDARD";
    private const int BackwardFlag = 2;
    private const int HiddenAttribute = 1;
    private const int ConstantAttribute = 2;
    private static readonly WrittenText s_nothing = new() { Raw = "" };

    /// <summary>The text of a record; null when it is empty or out of range.</summary>
    public PlacedText? Map(EntityRecord record)
    {
        var text = record.Type == "MTEXT" ? MText(record) : Text(record);
        return text.Content.Length > 0 && PlacedTexts.IsInRange(text) ? text : null;
    }

    /// <summary>The text of a constant ATTDEF, which every copy of its block shows; null for any other ATTDEF.</summary>
    public PlacedText? MapConstant(EntityRecord record) => ((int)record.First(70, 0.0) & ConstantAttribute) != 0 ? Map(record) : null;

    private static bool IsAttribute(EntityRecord record) => record.Kind is RecordKind.Attribute or RecordKind.AttributeDefinition;

    private PlacedText MText(EntityRecord record)
    {
        var attachment = Math.Clamp((int)record.First(71, 1.0), 1, 9) - 1;
        return Common(record) with
        {
            Written = WrittenTexts.OfMText(record),
            Content = TextContent.OfMText(record.TextOf(1, 3)),
            Position = record.PointOrOrigin(10),
            Rotation = Direction(record),
            Mirrored = record.Extrusion().Z < 0.0,
            FrameWidth = record.First(41, 0.0),
            LineSpacing = record.First(44, 1.0),
            Column = (TextColumnAlignment)(attachment % 3),
            Row = (TextRowAlignment)(TextRowAlignment.Top - (attachment / 3)),
        };
    }

    /// <summary>Direction of the lines: an angle (50) or a vector (11), whichever comes last.</summary>
    private static Angle Direction(EntityRecord record)
    {
        if (WrittenTexts.XAxis(record) is { } vector) return Angle.Direction(vector.X, vector.Y);
        var turn = WrittenTexts.Rotation(record);
        return record.Extrusion().Z < 0.0 ? Angle.FromDegrees(180.0) - turn : turn; // the angle is measured in the entity's own system, the vector in the world
    }

    private PlacedText Text(EntityRecord record)
    {
        var column = (TextColumnAlignment)Math.Clamp((int)record.First(72, 0.0), 0, 5);
        var row = (TextRowAlignment)Math.Clamp((int)record.First(IsAttribute(record) ? 74 : 73, 0.0), 0, 3);
        var between = column is TextColumnAlignment.Aligned or TextColumnAlignment.Fit;
        var second = record.Has(11) && (column != TextColumnAlignment.Left || row != TextRowAlignment.Baseline);
        var text = Common(record) with
        {
            Written = WrittenTexts.OfText(record, IsAttribute(record)),
            Content = TextContent.OfText(record.TextOf(1)),
            Position = record.PointOrOrigin(second && !between ? 11 : 10),
            End = second && between ? record.PointOrOrigin(11) : null,
            Rotation = Angle.FromDegrees(record.First(50, 0.0)),
            WidthFactor = record.First(41, 1.0),
            Oblique = Angle.FromDegrees(record.First(51, 0.0)),
            Mirrored = ((int)record.First(71, 0.0) & BackwardFlag) != 0,
            Column = column,
            Row = row,
        };
        var direction = record.Extrusion();
        return direction == default || Placement.FromExtrusion(direction) is { IsIdentity: true } ? text : PlacedTexts.Placed(text, Placement.FromExtrusion(direction));
    }

    private PlacedText Common(EntityRecord record)
    {
        var style = record.TextOf(7) is { Length: > 0 } named ? named : StandardStyle;
        return new PlacedText
        {
            Type = record.Type,
            Written = s_nothing,
            Content = "",
            Position = default,
            Height = record.First(40, 0.0),
            Rotation = default,
            Style = style,
            Font = styles.FontOf(style),
            Colour = record.Colour,
            Layer = record.Layer,
            Handle = record.Handle,
            SourceLine = record.Line,
            Hidden = record.Invisible || (IsAttribute(record) && ((int)record.First(70, 0.0) & HiddenAttribute) != 0),
        };
    }
}
