using Engraver.App.Texts;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Settings;

namespace Engraver.App.Menus;

/// <summary>The name of a command in menus and tips.</summary>
public static class MenuTitle
{
    /// <summary>The text <c>Command.NAME</c>; without one, the name of the setting that the command changes, otherwise the command's own name.</summary>
    public static string Find(string name) => Text.Find("Command." + name) ?? SettingTable.All.FirstOrDefault(setting => setting.Command == name)?.Name ?? name;

    /// <summary>The shortest input for the command: its shortest alias, or the name.</summary>
    public static string ShortestInput(CommandSession session, string name) =>
        session.Aliases.Commands.Where(pair => pair.Value == name).Select(pair => pair.Key).OrderBy(alias => alias.Length).ThenBy(alias => alias, StringComparer.Ordinal).FirstOrDefault() ?? name;
}
