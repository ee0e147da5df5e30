using Avalonia;
using Avalonia.Input;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>The X server's button numbers: 1 to 3 are buttons, 4 to 7 the wheels, 8 and 9 the thumb's.</summary>
internal static class XButtons
{
    /// <returns>One notch, y positive away from the person and x positive to the left; null for a real button.</returns>
    public static Vector? WheelOf(uint number) => number switch
    {
        4 => new Vector(0, 1),
        5 => new Vector(0, -1),
        6 => new Vector(1, 0),
        7 => new Vector(-1, 0),
        _ => null,
    };

    public static MouseButton ButtonOf(uint number) => number switch
    {
        1 => MouseButton.Left,
        2 => MouseButton.Middle,
        3 => MouseButton.Right,
        8 => MouseButton.XButton1,
        9 => MouseButton.XButton2,
        _ => MouseButton.None,
    };
}
