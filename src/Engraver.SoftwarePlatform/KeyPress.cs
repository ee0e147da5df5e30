using Avalonia.Input;

namespace Engraver.SoftwarePlatform;

/// <summary>A key on its way to a window.</summary>
/// <param name="Key">What the key means in the layout in force.</param>
/// <param name="Modifiers">Those held before this event.</param>
/// <param name="IsDown">False when it is let go.</param>
/// <param name="IsRepeat">True for a press that the keyboard repeats while the key is held.</param>
public readonly record struct KeyPress(Key Key, KeyModifiers Modifiers, bool IsDown, bool IsRepeat);
