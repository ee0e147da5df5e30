namespace Engraver.Core.Dxf.Writing;

/// <summary>The handles that other objects of a written drawing refer to; all others are assigned from <see cref="FirstFree"/> on.</summary>
internal static class DxfHandles
{
    public const int None = 0;

    public const int BlockRecordTable = 1;

    public const int ModelSpace = 2;

    public const int PaperSpace = 3;

    public const int RootDictionary = 4;

    public const int GroupDictionary = 5;

    public const int LayoutDictionary = 6;

    public const int ModelLayout = 7;

    public const int PaperLayout = 8;

    public const int FirstFree = 0x10;

    /// <summary>First handle of the entities, unless there are very many layers, styles or linetypes.</summary>
    private const int FirstEntity = 0x400;

    /// <summary>Handles reserved for tables, blocks and objects, without those of layers, styles and linetypes; more than are needed.</summary>
    private const int TableHandles = 0x80;

    /// <summary>First handle of the entities of this sheet.</summary>
    public static int FirstEntityOf(DxfSheet sheet) => Math.Max(FirstEntity, TableHandles + sheet.Layers.Count + sheet.Styles.Count + sheet.Linetypes.Count);
}
