using Avalonia.Input;

namespace Engraver.App.Shell;

/// <summary>The keyboard shortcuts, as in AutoCAD. None of them starts motion.</summary>
public static class ShellKeys
{
    /// <summary>The command, or the action of the window, of a key; null for none.</summary>
    public static string? CommandOf(KeyEventArgs e) => (e.KeyModifiers, e.Key) switch
    {
        (KeyModifiers.None, Key.F1) => "HELP",
        (KeyModifiers.None, Key.F2) => "Window.History",
        (KeyModifiers.None, Key.F3) => "Switch.OSNAP",
        (KeyModifiers.None, Key.F7) => "Switch.GRID",
        (KeyModifiers.None, Key.F8) => "Switch.ORTHO",
        (KeyModifiers.None, Key.F9) => "Switch.SNAP",
        (KeyModifiers.None, Key.F10) => "Switch.POLAR",
        (KeyModifiers.None, Key.F12) => "Switch.DYNAMICINPUT",
        (KeyModifiers.Control or (KeyModifiers.Control | KeyModifiers.Shift), Key.OemPlus or Key.Add) => "Override.FeedFaster", // + needs Shift on some keyboards
        (KeyModifiers.Control, Key.OemMinus or Key.Subtract) => "Override.FeedSlower",
        (KeyModifiers.Control, Key.OemPeriod) => "Override.RapidsFaster",
        (KeyModifiers.Control, Key.OemComma) => "Override.RapidsSlower",
        (KeyModifiers.Control, Key.O) => "OPEN",
        (KeyModifiers.Control, Key.N) => "NEW",
        (KeyModifiers.Control, Key.S) => "QSAVE",
        (KeyModifiers.Control | KeyModifiers.Shift, Key.S) => "SAVEAS",
        (KeyModifiers.Control, Key.P) => "PLOT",
        (KeyModifiers.Control, Key.Q) => "QUIT",
        (KeyModifiers.Control, Key.D0) => "Window.Clean",
        (KeyModifiers.Control, Key.D1) => "Window.Palettes",
        (KeyModifiers.Control, Key.D9) => "Window.Pages",
        _ => null,
    };

    /// <summary>The same for keys that edit text in a text box.</summary>
    public static string? CommandOutsideText(KeyEventArgs e) => (e.KeyModifiers, e.Key) switch
    {
        (KeyModifiers.Control, Key.A) => "Window.SelectAll",
        (KeyModifiers.Control, Key.Z) => "U",
        (KeyModifiers.Control, Key.Y) => "REDO",
        (KeyModifiers.None, Key.Delete) => "Window.EraseSelected",
        _ => null,
    };
}
