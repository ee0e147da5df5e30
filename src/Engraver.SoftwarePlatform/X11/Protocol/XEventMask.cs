namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>Bits of the X protocol that select a window's events.</summary>
internal static class XEventMask
{
    public const int PropertyChange = 0x400000;
    public const int StructureNotify = 0x20000;

    /// <summary>Keys, buttons, motion, enter and leave, exposure, structure, focus, properties.</summary>
    public const int Window = 0x1 | 0x2 | 0x4 | 0x8 | 0x10 | 0x20 | 0x40 | 0x8000 | StructureNotify | 0x200000 | PropertyChange;

    /// <summary>Substructure redirect and notify: messages to the window manager go to the root window with this.</summary>
    public const int ToWindowManager = 0x180000;
}
