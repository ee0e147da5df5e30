using Avalonia.Input;

namespace Engraver.SoftwarePlatform;

/// <summary>A key event on its way to a window.</summary>
/// <param name="Key">The key in the present keyboard layout.</param>
/// <param name="Modifiers">The modifiers held before this event.</param>
/// <param name="IsDown">False for a release.</param>
/// <param name="IsRepeat">True for an automatic repeat while the key is held.</param>
public readonly record struct KeyPress(Key Key, KeyModifiers Modifiers, bool IsDown, bool IsRepeat);
