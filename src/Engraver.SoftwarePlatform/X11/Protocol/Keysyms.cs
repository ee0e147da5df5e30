using Avalonia.Input;
using Engraver.SoftwarePlatform.Input;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>Avalonia's key for an X key symbol (values of X11/keysymdef.h).</summary>
internal static class Keysyms
{
    /// <returns><see cref="Key.None"/> for a symbol without its own key, such as an accented letter.</returns>
    public static Key KeyOf(nint keysym) => keysym switch
    {
        >= 0x20 and <= 0x7E => CharacterKeys.KeyOf((int)keysym),
        >= 0xFFBE and <= 0xFFD5 => Key.F1 + (int)(keysym - 0xFFBE),
        >= 0xFFB0 and <= 0xFFB9 => Key.NumPad0 + (int)(keysym - 0xFFB0),
        >= 0xFF95 and <= 0xFF9F => KeypadWithoutNumLock(keysym),
        _ => Editing(keysym) is var key and not Key.None ? key : Modifier(keysym),
    };

    private static Key Editing(nint keysym) => keysym switch
    {
        0xFF08 => Key.Back,
        0xFF09 or 0xFE20 => Key.Tab, // Tab, and ISO_Left_Tab (Shift+Tab)
        0xFF0A => Key.LineFeed,
        0xFF0B => Key.Clear,
        0xFF0D or 0xFF8D => Key.Enter, // the main one and the keypad's
        0xFF13 or 0xFF6B => Key.Pause, // Pause, and Break (Control+Pause): the same key
        0xFF14 => Key.Scroll,
        0xFF15 => Key.Snapshot, // Sys_Req is Alt+Print
        0xFF61 => Key.PrintScreen,
        0xFF1B => Key.Escape,
        0xFFFF => Key.Delete,
        0xFF50 => Key.Home,
        0xFF51 => Key.Left,
        0xFF52 => Key.Up,
        0xFF53 => Key.Right,
        0xFF54 => Key.Down,
        0xFF55 => Key.PageUp,
        0xFF56 => Key.PageDown,
        0xFF57 => Key.End,
        0xFF63 => Key.Insert,
        0xFF67 => Key.Apps,
        0xFF69 => Key.Cancel,
        0xFF6A => Key.Help,
        0xFF80 => Key.Space,
        0xFFAA => Key.Multiply,
        0xFFAB => Key.Add,
        0xFFAC => Key.Separator,
        0xFFAD => Key.Subtract,
        0xFFAE => Key.Decimal,
        0xFFAF => Key.Divide,
        _ => Key.None,
    };

    private static Key Modifier(nint keysym) => keysym switch
    {
        0xFF7F => Key.NumLock,
        0xFFE1 => Key.LeftShift,
        0xFFE2 => Key.RightShift,
        0xFFE3 => Key.LeftCtrl,
        0xFFE4 => Key.RightCtrl,
        0xFFE5 => Key.CapsLock,
        0xFFE7 or 0xFFE9 => Key.LeftAlt, // Meta_L is Shift+Alt
        0xFFE8 or 0xFFEA or 0xFE03 => Key.RightAlt, // and AltGr
        0xFFEB => Key.LWin,
        0xFFEC => Key.RWin,
        _ => Key.None,
    };

    private static Key KeypadWithoutNumLock(nint keysym) => keysym switch
    {
        0xFF95 => Key.Home,
        0xFF96 => Key.Left,
        0xFF97 => Key.Up,
        0xFF98 => Key.Right,
        0xFF99 => Key.Down,
        0xFF9A => Key.PageUp,
        0xFF9B => Key.PageDown,
        0xFF9C => Key.End,
        0xFF9D => Key.Clear,
        0xFF9E => Key.Insert,
        _ => Key.Delete,
    };
}
