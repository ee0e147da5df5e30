namespace Engraver.SoftwarePlatform;

/// <summary>Called on the input thread before the key is queued for the user interface, so that it works while the user interface is busy. True swallows
/// the key.</summary>
/// <remarks>Must be quick and must not call the user interface synchronously: while it runs, no other input is read.</remarks>
public delegate bool KeyFilter(in KeyPress press);
