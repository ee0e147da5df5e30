using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Text;

/// <summary>Takes the values of a record of text as they are written.</summary>
internal static class WrittenTexts
{
    /// <summary>Group code that begins the columns of an MTEXT; a 50 after it is the height of a column, not an angle.</summary>
    private const int ColumnType = 75;

    public static WrittenText OfText(EntityRecord record, bool isAttribute) => new()
    {
        DamagedGroup = record.DamagedGroup,
        Raw = record.RawOf(1),
        Insertion = record.PointOrOrigin(10),
        Second = record.Has(11) ? record.PointOrOrigin(11) : null,
        Height = record.First(40, 0.0),
        WidthFactor = record.First(41, 1.0),
        Oblique = Angle.FromDegrees(record.First(51, 0.0)),
        Rotation = Angle.FromDegrees(record.First(50, 0.0)),
        Generation = (TextGeneration)(record.FirstFlags(71) & (int)(TextGeneration.Backwards | TextGeneration.UpsideDown)),
        Horizontal = record.FirstFlags(72),
        Vertical = record.FirstFlags(isAttribute ? 74 : 73),
        Extrusion = record.Extrusion(),
        Tag = isAttribute ? record.TextOf(2) : "",
        Prompt = record.Kind == RecordKind.AttributeDefinition ? record.TextOf(3) : "",
        FieldLength = isAttribute ? record.FirstFlags(73) : 0,
        AttributeFlags = isAttribute ? record.FirstFlags(70) : 0,
    };

    public static WrittenText OfMText(EntityRecord record)
    {
        var (columns, height) = TextColumnReader.Read(record);
        return new WrittenText
        {
            DamagedGroup = record.DamagedGroup,
            Raw = record.RawOf(1, 3),
            Insertion = record.PointOrOrigin(10),
            Height = record.First(40, 0.0),
            Rotation = Rotation(record),
            Extrusion = record.Extrusion(),
            Paragraphs = new WrittenParagraphs
            {
                Attachment = record.FirstFlags(71, 1),
                FlowDirection = record.FirstFlags(72, 1),
                ReferenceWidth = record.First(41, 0.0),
                DefinedHeight = record.First(46, height),
                LineSpacingStyle = record.FirstFlags(73, 1),
                LineSpacingFactor = record.First(44, 1.0),
                XAxis = XAxis(record),
                Columns = columns,
            },
        };
    }

    /// <summary>The rotation of an MTEXT (50).</summary>
    public static Angle Rotation(EntityRecord record) => LastRotation(record) >= 0 ? Angle.FromDegrees(record.First(50, 0.0)) : default;

    /// <summary>The direction of the lines of an MTEXT (11) unless a rotation (50) comes after it, or null.</summary>
    public static Vector3D? XAxis(EntityRecord record)
    {
        var vector = record.Sequence.FindLastIndex(pair => pair.Code == 11);
        return vector > LastRotation(record) ? new Vector3D(record.Number(11, 1.0), record.Number(21, 0.0), record.Number(31, 0.0)) : null;
    }

    private static int LastRotation(EntityRecord record)
    {
        var end = record.Sequence.FindIndex(pair => pair.Code == ColumnType);
        return end < 0 ? record.Sequence.FindLastIndex(pair => pair.Code == 50) : end == 0 ? -1 : record.Sequence.FindLastIndex(end - 1, pair => pair.Code == 50);
    }
}
