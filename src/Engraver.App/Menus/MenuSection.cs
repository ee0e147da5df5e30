namespace Engraver.App.Menus;

/// <summary>One top-level menu.</summary>
/// <param name="Key">Name of its text (<c>Menu.File</c>).</param>
/// <param name="Entries">Names of commands; empty is a separator; a name with a dot is an act of the window itself (<c>Window.Exit</c>).</param>
public sealed record MenuSection(string Key, IReadOnlyList<string> Entries);
