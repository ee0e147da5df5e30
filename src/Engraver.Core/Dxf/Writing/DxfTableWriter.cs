using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf.Writing;

/// <summary>Writes the TABLES section: all nine tables, most with the one row that every drawing has (DXF reference, "TABLES Section").</summary>
internal sealed class DxfTableWriter(DxfTagWriter tags)
{
    private const int Frozen = 1;
    private const int Locked = 4;
    private const int Vertical = 4;

    public void Write(DxfSheet sheet)
    {
        var (layers, styles) = (sheet.Layers, sheet.Styles);
        Table("VPORT", ["*Active"], ViewPort);
        Table<Linetype>("LTYPE", [new("ByBlock"), new("ByLayer"), new("Continuous"), .. sheet.Linetypes], LineType);
        Table<DxfSheetLayer>("LAYER", layers.Any(layer => layer.Name == "0") ? [.. layers] : [new DxfSheetLayer("0", 7), .. layers], Layer);
        Table<TextStyle>("STYLE", [.. styles], Style);
        Table<string>("VIEW", [], (_, _) => { });
        Table<string>("UCS", [], (_, _) => { });
        Table("APPID", ["ACAD", DxfWriter.Application], (name, table) => Row("APPID", "AcDbRegAppTableRecord", name, table));
        Table("DIMSTYLE", ["Standard"], (name, table) => Row("DIMSTYLE", "AcDbDimStyleTableRecord", name, table));
        BlockRecords();
    }

    private void Table<T>(string name, ReadOnlySpan<T> rows, Action<T, int> write)
    {
        var table = BeginTable(name, rows.Length);
        foreach (var row in rows) write(row, table);
        tags.Text(0, "ENDTAB");
    }

    private int BeginTable(string name, int rows)
    {
        var handle = tags.NextHandle();
        OpenTable(name, handle, rows);
        if (name == "DIMSTYLE") tags.Class("AcDbDimStyleTable");
        return handle;
    }

    private void OpenTable(string name, int handle, int rows) =>
        tags.Text(0, "TABLE").Text(2, name).Handle(5, handle).Handle(330, DxfHandles.None).Class("AcDbSymbolTable").Integer(70, rows);

    private DxfTagWriter Row(string type, string marker, string name, int table, int flags = 0) =>
        tags.Begin(type, table).Class("AcDbSymbolTableRecord").Class(marker).Text(2, name).Integer(70, flags);

    private void ViewPort(string name, int table) => Row("VPORT", "AcDbViewportTableRecord", name, table)
        .Real(10, 0.0).Real(20, 0.0).Real(11, 1.0).Real(21, 1.0).Real(12, 0.0).Real(22, 0.0).Real(13, 0.0).Real(23, 0.0)
        .Real(14, 10.0).Real(24, 10.0).Real(15, 10.0).Real(25, 10.0).Real(16, 0.0).Real(26, 0.0).Real(36, 1.0).Real(17, 0.0).Real(27, 0.0).Real(37, 0.0)
        .Real(40, 300.0).Real(41, 1.6).Real(42, 50.0).Real(43, 0.0).Real(44, 0.0).Real(50, 0.0).Real(51, 0.0)
        .Integer(71, 0).Integer(72, 100).Integer(73, 1).Integer(74, 3).Integer(75, 0).Integer(76, 0).Integer(77, 0).Integer(78, 0);

    private void LineType(Linetype linetype, int table)
    {
        Row("LTYPE", "AcDbLinetypeTableRecord", linetype.Name, table).Text(3, linetype.Name == "Continuous" ? "Solid line" : "").Integer(72, 65).Integer(73, linetype.Elements.Count).Real(40, linetype.PatternLength);
        foreach (var element in linetype.Elements) tags.Real(49, element).Integer(74, 0);
    }

    private void Layer(DxfSheetLayer layer, int table)
    {
        Row("LAYER", "AcDbLayerTableRecord", layer.Name, table, (layer.Frozen ? Frozen : 0) | (layer.Locked ? Locked : 0)).Integer(62, layer.On ? layer.Colour : -layer.Colour);
        if (layer.Rgb is { } rgb) tags.Integer(EntityRecord.TrueColour, (int)rgb);
        tags.Text(6, layer.Linetype);
        if (!layer.Plots) tags.Integer(290, 0);
        tags.Integer(370, layer.Lineweight);
    }

    private void Style(TextStyle style, int table)
    {
        Row("STYLE", "AcDbTextStyleTableRecord", style.Name, table, style.IsVertical ? Vertical : 0)
            .Real(40, style.FixedHeight).Real(41, style.WidthFactor).Real(50, style.Oblique.Degrees).Integer(71, (int)style.Generation).Real(42, 2.5)
            .Text(3, style.FontFile.Length > 0 || style.Family.Length > 0 ? style.FontFile : "txt").Text(4, style.BigFontFile);
        if (style.Family.Length > 0) tags.Text(1001, "ACAD").Text(1000, style.Family).Integer(1071, style.FamilyFlags);
    }

    private void BlockRecords()
    {
        OpenTable("BLOCK_RECORD", DxfHandles.BlockRecordTable, 2);
        BlockRecord("*Model_Space", DxfHandles.ModelSpace, DxfHandles.ModelLayout);
        BlockRecord("*Paper_Space", DxfHandles.PaperSpace, DxfHandles.PaperLayout);
        tags.Text(0, "ENDTAB");
    }

    private void BlockRecord(string name, int handle, int layout) => tags.Begin("BLOCK_RECORD", DxfHandles.BlockRecordTable, handle)
        .Class("AcDbSymbolTableRecord").Class("AcDbBlockTableRecord").Text(2, name).Handle(340, layout);
}
