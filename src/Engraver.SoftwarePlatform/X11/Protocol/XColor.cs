using System.Runtime.InteropServices;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>A colour of 16 bits a channel (X11/Xlib.h, 64-bit Linux).</summary>
[StructLayout(LayoutKind.Explicit, Size = 16)]
internal struct XColor
{
    [FieldOffset(8)] public ushort Red;
    [FieldOffset(10)] public ushort Green;
    [FieldOffset(12)] public ushort Blue;
    [FieldOffset(14)] public byte Flags;
}
