using System.Runtime.InteropServices;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>A request that the server refused (X11/Xlib.h, 64-bit Linux).</summary>
[StructLayout(LayoutKind.Explicit, Size = 40)]
internal struct XErrorEvent
{
    [FieldOffset(16)] public nint Resource;
    [FieldOffset(32)] public byte ErrorCode;
    [FieldOffset(33)] public byte RequestCode;
}
