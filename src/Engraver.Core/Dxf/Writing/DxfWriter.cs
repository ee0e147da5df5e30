using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Writing;

/// <summary>Writes a drawing of lines, arcs, circles, ellipses, splines, texts and points as DXF AC1015 (AutoCAD 2000; AC1018, 2004, when it has true colours)
/// with every table, block and object that a strict reader requires.</summary>
/// <remarks>Order and direction are kept: a clockwise arc is written with the extrusion 0,0,-1 (see <see cref="DxfSegmentWriter"/>), and an entity with a role
/// carries extended data of <see cref="Application"/>: the role (1000), its place in the order of cutting and its stroke (1071 each), and of a CIRCLE the angle
/// at which it starts (1040, degrees, where it is not 0).</remarks>
public static class DxfWriter
{
    /// <summary>Name under which the extended data is registered.</summary>
    public const string Application = RestoredInserts.Application;

    /// <summary>Codes of $INSUNITS for English units.</summary>
    private static readonly int[] s_english = [1, 2, 3, 8, 9, 10, 21, 22, 23, 24];

    /// <summary>Writes the sheet; the same sheet gives the same text. LF line ends, ASCII.</summary>
    /// <exception cref="UnwritableEntityException">A number of an entity is not finite; the text is not complete.</exception>
    public static void Write(DxfSheet sheet, TextWriter output)
    {
        var tags = new DxfTagWriter(output, DxfHandles.FirstFree);
        tags.Section("HEADER", header => Header(header, sheet));
        tags.Section("CLASSES", _ => { });
        tags.Section("TABLES", tables => new DxfTableWriter(tables).Write(sheet));
        tags.Section("BLOCKS", Blocks);
        new DxfTagWriter(output, DxfHandles.FirstEntityOf(sheet)).Section("ENTITIES", entities => Entities(entities, sheet));
        tags.Section("OBJECTS", DxfObjectWriter.Write);
        tags.Text(0, "EOF");
    }

    private static void Header(DxfTagWriter tags, DxfSheet sheet)
    {
        var box = sheet.Bounds.IsEmpty ? Bounds2D.FromCorners(default, default) : sheet.Bounds;
        tags.Text(9, "$ACADVER").Text(1, sheet.HasTrueColours ? "AC1018" : "AC1015");
        tags.Text(9, "$DWGCODEPAGE").Text(3, "ANSI_1252");
        tags.Text(9, "$INSUNITS").Integer(70, sheet.InsUnits);
        tags.Text(9, "$MEASUREMENT").Integer(70, s_english.Contains(sheet.InsUnits) ? 0 : 1);
        if (sheet.LinetypeScale != 1.0) tags.Text(9, "$LTSCALE").Real(40, sheet.LinetypeScale);
        tags.Text(9, "$EXTMIN").Point(10, new Point2D(box.MinX, box.MinY));
        tags.Text(9, "$EXTMAX").Point(10, new Point2D(box.MaxX, box.MaxY));
        tags.Text(9, "$HANDSEED").Handle(5, DxfHandles.FirstEntityOf(sheet) + sheet.Handles);
    }

    private static void Blocks(DxfTagWriter tags)
    {
        foreach (var (name, owner) in new[] { ("*Model_Space", DxfHandles.ModelSpace), ("*Paper_Space", DxfHandles.PaperSpace) })
        {
            tags.Begin("BLOCK", owner).Class("AcDbEntity").Text(8, "0").Class("AcDbBlockBegin")
                .Text(2, name).Integer(70, 0).Point(10, default).Text(3, name).Text(1, "");
            tags.Begin("ENDBLK", owner).Class("AcDbEntity").Text(8, "0").Class("AcDbBlockEnd");
        }
    }

    private static void Entities(DxfTagWriter tags, DxfSheet sheet)
    {
        foreach (var entity in sheet.Entities)
        {
            DxfSegmentWriter.Write(tags, entity);
            if (entity.Role is { } role) ExtendedData(tags, role, entity);
            else if (entity.Heights is null) InsertData(tags, entity);
            if (!tags.IsFinite) throw new UnwritableEntityException(entity.Source);
        }

        foreach (var text in sheet.Texts) DxfTextWriter.Write(tags, text);
        foreach (var (point, layer, linetype) in sheet.Points) tags.BeginEntity("POINT", layer, point.Colour, point.Hidden, linetype).Class("AcDbPoint").Point(10, point.Position);
        if (!tags.IsFinite) throw new UnwritableEntityException(default);
    }

    /// <summary>First text of the extended data of a curve that comes from inserts.</summary>
    private const string InsertMark = RestoredInserts.Mark;

    /// <summary>The inserts of a curve: name, number and insertion point of each. A point of code 1011 moves with its entity in AutoCAD (DXF reference,
    /// "Extended Data").</summary>
    internal static void InsertData(DxfTagWriter tags, in DxfSheetEntity entity)
    {
        if (entity.Inserts is not { Count: > 0 } inserts) return;
        tags.Text(1001, Application).Text(1000, InsertMark);
        foreach (var (block, number, place) in inserts) tags.Text(1000, block).Integer(1071, number).Point(1011, place);
    }

    private static void ExtendedData(DxfTagWriter tags, string role, in DxfSheetEntity entity)
    {
        tags.Text(1001, Application).Text(1000, role).Integer(1071, entity.Sequence).Integer(1071, entity.Stroke);
        if (entity.Segment.Kind == SegmentKind.Circle && DxfSegmentWriter.StartOf(entity.Segment.Arc).Degrees is not 0.0 and var start) tags.Real(1040, start);
    }
}
