namespace Engraver.Core.Dxf.Writing;

/// <summary>Writes the OBJECTS section: the root dictionary with groups and the two layouts that belong to the two spaces (DXF reference, "OBJECTS
/// Section").</summary>
internal static class DxfObjectWriter
{
    /// <summary>Bit 1024 of a layout's plot flags: the layout is the model.</summary>
    private const int ModelType = 1024;

    public static void Write(DxfTagWriter tags)
    {
        Dictionary(tags, DxfHandles.RootDictionary, DxfHandles.None, ("ACAD_GROUP", DxfHandles.GroupDictionary), ("ACAD_LAYOUT", DxfHandles.LayoutDictionary));
        Dictionary(tags, DxfHandles.GroupDictionary, DxfHandles.RootDictionary);
        Dictionary(tags, DxfHandles.LayoutDictionary, DxfHandles.RootDictionary, ("Model", DxfHandles.ModelLayout), ("Layout1", DxfHandles.PaperLayout));
        Layout(tags, "Model", DxfHandles.ModelLayout, DxfHandles.ModelSpace, 0, ModelType);
        Layout(tags, "Layout1", DxfHandles.PaperLayout, DxfHandles.PaperSpace, 1, 0);
    }

    private static void Dictionary(DxfTagWriter tags, int handle, int owner, params (string Name, int Handle)[] entries)
    {
        tags.Begin("DICTIONARY", owner, handle).Class("AcDbDictionary").Integer(281, 1);
        foreach (var entry in entries) tags.Text(3, entry.Name).Handle(350, entry.Handle);
    }

    private static void Layout(DxfTagWriter tags, string name, int handle, int space, int tab, int plotType)
    {
        tags.Begin("LAYOUT", DxfHandles.LayoutDictionary, handle).Class("AcDbPlotSettings")
            .Text(1, "").Text(2, "none_device").Text(4, "").Text(6, "")
            .Real(40, 0.0).Real(41, 0.0).Real(42, 0.0).Real(43, 0.0).Real(44, 0.0).Real(45, 0.0).Real(46, 0.0).Real(47, 0.0).Real(48, 0.0).Real(49, 0.0)
            .Real(140, 0.0).Real(141, 0.0).Real(142, 1.0).Real(143, 1.0)
            .Integer(70, 688 | plotType).Integer(72, 1).Integer(73, 0).Integer(74, 0).Text(7, "").Integer(75, 16)
            .Real(147, 1.0).Real(148, 0.0).Real(149, 0.0);
        tags.Class("AcDbLayout").Text(1, name).Integer(70, 1).Integer(71, tab)
            .Real(10, 0.0).Real(20, 0.0).Real(11, 420.0).Real(21, 297.0).Point(12, default).Point(14, default).Point(15, default)
            .Real(146, 0.0).Point(13, default).Real(16, 1.0).Real(26, 0.0).Real(36, 0.0).Real(17, 0.0).Real(27, 1.0).Real(37, 0.0).Integer(76, 0)
            .Handle(330, space);
    }
}
