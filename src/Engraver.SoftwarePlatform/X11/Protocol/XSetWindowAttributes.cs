using System.Runtime.InteropServices;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>Attributes for the creation of a window (X11/Xlib.h, 64-bit Linux).</summary>
[StructLayout(LayoutKind.Explicit, Size = 112)]
internal struct XSetWindowAttributes
{
    public const nuint BackgroundAndGravity = 1 | (1 << 4);
    public const int NorthWestGravity = 1;

    [FieldOffset(0)] public nint BackgroundPixmap;
    [FieldOffset(32)] public int BitGravity;
}
