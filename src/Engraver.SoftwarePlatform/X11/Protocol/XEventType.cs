namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>Numbers of the X protocol.</summary>
internal enum XEventType
{
    KeyPress = 2,
    KeyRelease = 3,
    ButtonPress = 4,
    ButtonRelease = 5,
    MotionNotify = 6,
    EnterNotify = 7,
    LeaveNotify = 8,
    FocusIn = 9,
    FocusOut = 10,
    Expose = 12,
    DestroyNotify = 17,
    MapNotify = 19,
    ConfigureNotify = 22,
    PropertyNotify = 28,
    SelectionClear = 29,
    SelectionRequest = 30,
    SelectionNotify = 31,
    ClientMessage = 33,
    MappingNotify = 34,
}
