using System.Runtime.InteropServices;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>Xlib's union of events, as far as it is used: offsets of 64-bit Linux (X11/Xlib.h). <see cref="Type"/> says which fields are valid.</summary>
[StructLayout(LayoutKind.Explicit, Size = 192)]
internal unsafe struct XEvent
{
    [FieldOffset(0)] public XEventType Type;
    [FieldOffset(24)] public nint Display;
    [FieldOffset(32)] public nint Window;

    // keys, buttons, motion
    [FieldOffset(56)] public nint Time;
    [FieldOffset(64)] public int X;
    [FieldOffset(68)] public int Y;
    [FieldOffset(80)] public uint State;
    [FieldOffset(84)] public uint Detail; // key code or button

    // enter, leave
    [FieldOffset(80)] public int CrossingMode;
    [FieldOffset(84)] public int CrossingDetail;
    [FieldOffset(96)] public uint CrossingState;

    // focus
    [FieldOffset(40)] public int FocusMode;
    [FieldOffset(44)] public int FocusDetail;

    // exposed area
    [FieldOffset(40)] public int ExposeX;
    [FieldOffset(44)] public int ExposeY;
    [FieldOffset(48)] public int ExposeWidth;
    [FieldOffset(52)] public int ExposeHeight;

    // configure
    [FieldOffset(56)] public int Width;
    [FieldOffset(60)] public int Height;

    // message
    [FieldOffset(40)] public nint MessageType;
    [FieldOffset(48)] public int Format;
    [FieldOffset(56)] public fixed long Data[5];

    // property
    [FieldOffset(40)] public nint Property;
    [FieldOffset(48)] public nint PropertyTime;
    [FieldOffset(56)] public int PropertyState; // 0 new value, 1 deleted

    // selection request (this program owns the selection): Window is the owner
    [FieldOffset(40)] public nint Requestor;
    [FieldOffset(48)] public nint RequestSelection;
    [FieldOffset(56)] public nint RequestTarget;
    [FieldOffset(64)] public nint RequestProperty;
    [FieldOffset(72)] public nint RequestTime;

    // selection notify: Window is the requestor
    [FieldOffset(40)] public nint Selection;
    [FieldOffset(48)] public nint Target;
    [FieldOffset(56)] public nint AnswerProperty;
    [FieldOffset(64)] public nint AnswerTime;
}
