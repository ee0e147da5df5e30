using Engraver.App.Texts;
using Engraver.Workbench.Commands;

namespace Engraver.App.Menus;

/// <summary>What a command is called in menus and tips.</summary>
public static class MenuTitle
{
    /// <summary>The text <c>Command.NAME</c>; a command without one is shown by its name.</summary>
    public static string Of(string name) => Text.Find("Command." + name) ?? name;

    /// <summary>The way to type it: the shortest alias, else the name.</summary>
    public static string Typed(CommandSession session, string name) =>
        session.Aliases.Commands.Where(pair => pair.Value == name).Select(pair => pair.Key).OrderBy(alias => alias.Length).ThenBy(alias => alias, StringComparer.Ordinal).FirstOrDefault() ?? name;
}
