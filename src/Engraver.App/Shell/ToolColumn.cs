using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Menus;
using Engraver.App.Texts;

namespace Engraver.App.Shell;

/// <summary>The buttons of the tool column. Their tips name the command and its alias, so that the operator learns to type them.</summary>
public static class ToolColumn
{
    private static readonly IReadOnlyList<(string Command, string[] Answers, string Icon, bool EndsGroup)> s_tools =
    [
        ("OPEN", [], "OpenIcon", false),
        ("U", [], "UndoIcon", false),
        ("REDO", [], "RedoIcon", true),
        ("ZOOM", ["Extents"], "ExtentsIcon", false),
        ("ZOOM", ["Window"], "ZoomWindowIcon", false),
        ("ZOOM", ["Previous"], "ZoomPreviousIcon", true),
        ("SELECT", [], "SelectIcon", false),
        ("CHECK", [], "CheckIcon", true),
        ("AUTOSEQUENCE", [], "OrderIcon", false),
        ("ENTER", [], "EnterIcon", true),
        ("CNCSIM", [], "SimulateIcon", false),
        ("CNCCONNECT", [], "ConnectIcon", false),
    ];

    public static IReadOnlyList<ToolButton> For(DesktopModel desk, Func<string, System.Windows.Input.ICommand> commandOf) =>
        [.. s_tools.Where(tool => desk.Session.Catalog.Find(tool.Command) is not null).Select(tool => Make(tool.Command, tool.Answers, tool.Icon, tool.EndsGroup, desk, commandOf))];

    private static ToolButton Make(string command, string[] answers, string icon, bool endsGroup, DesktopModel desk, Func<string, System.Windows.Input.ICommand> commandOf)
    {
        var name = answers.Length == 0 ? command : $"{command}.{answers[0]}";
        var typed = MenuTitle.ShortestInput(desk.Session, command);
        var tip = Text.Get("Tool.Tip", MenuTitle.Find(name), typed == command ? command : $"{command}, {typed}");
        var does = answers.Length == 0 ? commandOf(command) : new RelayCommand(() => _ = desk.Queue.RunAsync([command, .. answers]));
        return new ToolButton(command, (Geometry)Application.Current!.FindResource(icon)!, tip, does, endsGroup);
    }
}
