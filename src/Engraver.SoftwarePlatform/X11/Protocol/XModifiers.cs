using Avalonia.Input;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>The modifier bits of an X event. Lock (2), Num Lock (16) and the level shifts (32, 128) are not modifiers to a program.</summary>
internal static class XModifiers
{
    public static RawInputModifiers FromState(uint state)
    {
        var modifiers = RawInputModifiers.None;
        if ((state & 1) != 0) modifiers |= RawInputModifiers.Shift;
        if ((state & 4) != 0) modifiers |= RawInputModifiers.Control;
        if ((state & 8) != 0) modifiers |= RawInputModifiers.Alt;
        if ((state & 64) != 0) modifiers |= RawInputModifiers.Meta;
        if ((state & 256) != 0) modifiers |= RawInputModifiers.LeftMouseButton;
        if ((state & 512) != 0) modifiers |= RawInputModifiers.MiddleMouseButton;
        if ((state & 1024) != 0) modifiers |= RawInputModifiers.RightMouseButton;
        return modifiers;
    }
}
