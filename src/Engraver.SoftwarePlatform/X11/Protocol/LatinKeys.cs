using Avalonia.Input;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>The letter keys by their position (key codes of evdev keyboards), so that shortcuts work in layouts without Latin letters.</summary>
internal static class LatinKeys
{
    private const string FirstRow = "qwertyuiop"; // key codes 24 to 33
    private const string SecondRow = "asdfghjkl"; // 38 to 46
    private const string ThirdRow = "zxcvbnm"; // 52 to 58

    public static Key KeyOf(uint keycode) => keycode switch
    {
        >= 24 and <= 33 => KeyAt(FirstRow, keycode - 24),
        >= 38 and <= 46 => KeyAt(SecondRow, keycode - 38),
        >= 52 and <= 58 => KeyAt(ThirdRow, keycode - 52),
        _ => Key.None,
    };

    private static Key KeyAt(string row, uint place) => Key.A + (row[(int)place] - 'a');
}
