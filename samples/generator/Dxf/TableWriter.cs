namespace Engraver.Samples.Dxf;

/// <summary>Writes the TABLES section: the least that CAD programs accept, plus our layers and blocks (DXF Reference, "TABLES Section").</summary>
internal sealed class TableWriter(TagStream tags)
{
    private const string NoOwner = "0";

    /// <param name="document">Whose layers are listed.</param>
    /// <param name="blockRecords">Block name and the handle its record shall have.</param>
    public void Write(DxfDocument document, IReadOnlyList<(string Name, string Handle)> blockRecords)
    {
        tags.Text(0, "SECTION").Text(2, "TABLES");
        WriteTable("LTYPE", LineTypesOf(document.Version), WriteLineType);
        WriteTable("LAYER", [new DxfLayer("0", 7), .. document.Layers], WriteLayer);
        WriteTable("STYLE", [new DxfTextStyle("STANDARD", "txt"), .. document.Styles], WriteTextStyle);
        if (!tags.IsR12)
        {
            WriteTable("VPORT", Array.Empty<string>(), static (_, _) => { });
            WriteTable("VIEW", Array.Empty<string>(), static (_, _) => { });
            WriteTable("UCS", Array.Empty<string>(), static (_, _) => { });
            WriteTable("APPID", ["ACAD"], (name, table) => Row("APPID", "AcDbRegAppTableRecord", name, table, flags: 0));
            WriteTable("DIMSTYLE", ["STANDARD"], (name, table) => Row("DIMSTYLE", "AcDbDimStyleTableRecord", name, table, flags: 0));
            WriteTable("BLOCK_RECORD", blockRecords, WriteBlockRecord);
        }

        tags.Text(0, "ENDSEC");
    }

    private static string[] LineTypesOf(DxfVersion version) => version == DxfVersion.R12 ? ["CONTINUOUS"] : ["ByBlock", "ByLayer", "Continuous"];

    private void WriteTable<T>(string name, IReadOnlyList<T> rows, Action<T, string> writeRow)
    {
        var handle = tags.NextHandle();
        tags.Text(0, "TABLE").Text(2, name);
        if (!tags.IsR12)
        {
            tags.Text(5, handle).Text(330, NoOwner).Subclass("AcDbSymbolTable");
        }

        tags.Integer(70, rows.Count);
        if (name == "DIMSTYLE")
        {
            tags.Subclass("AcDbDimStyleTable");
        }

        foreach (var row in rows)
        {
            writeRow(row, handle);
        }

        tags.Text(0, "ENDTAB");
    }

    private TagStream Row(string type, string subclass, string name, string table, int flags) =>
        tags.Begin(type, table).Subclass("AcDbSymbolTableRecord").Subclass(subclass).Text(2, name).Integer(70, flags);

    private void WriteLineType(string name, string table) =>
        Row("LTYPE", "AcDbLinetypeTableRecord", name, table, flags: 0).Text(3, "").Integer(72, 65).Integer(73, 0).Real(40, 0);

    /// <remarks>A layer that is off has a negative colour; frozen is bit 1 of the flags; R12 cannot say that a layer does not plot.</remarks>
    private void WriteLayer(DxfLayer layer, string table)
    {
        Row("LAYER", "AcDbLayerTableRecord", layer.Name, table, layer.Frozen ? 1 : 0)
            .Integer(62, layer.Off ? -layer.Colour : layer.Colour).Text(6, tags.IsR12 ? "CONTINUOUS" : "Continuous");
        if (!layer.Plots && !tags.IsR12)
        {
            tags.Integer(290, 0);
        }
    }

    private void WriteTextStyle(DxfTextStyle style, string table) =>
        Row("STYLE", "AcDbTextStyleTableRecord", style.Name, table, flags: 0)
            .Real(40, 0).Real(41, 1).Real(50, 0).Integer(71, 0).Real(42, 2.5).Text(3, style.FontFile).Text(4, "");

    private void WriteBlockRecord((string Name, string Handle) block, string table) =>
        tags.Begin("BLOCK_RECORD", table, block.Handle).Subclass("AcDbSymbolTableRecord").Subclass("AcDbBlockTableRecord").Text(2, block.Name);
}
