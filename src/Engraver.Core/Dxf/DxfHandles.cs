namespace Engraver.Core.Dxf;

/// <summary>The handles that other objects of a written drawing point at; all others are handed out from <see cref="FirstFree"/> on.</summary>
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

    /// <summary>More than tables, blocks and objects take whatever the layers; entities begin behind it.</summary>
    public const int FirstEntity = 0x400;
}
