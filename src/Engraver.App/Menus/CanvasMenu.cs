using Avalonia.Controls;
using Engraver.App.Binding;
using Engraver.App.CommandWindow;
using Engraver.App.Desk;
using Engraver.App.Texts;

namespace Engraver.App.Menus;

/// <summary>The context menu of the canvas, for the current state: a command with a prompt (Enter, Cancel, its options), selected objects, or
/// neither.</summary>
/// <remarks>AutoCAD's order: repeat the last command, recent input, then the entries for the state. Neither repeats a command that starts motion.</remarks>
internal sealed class CanvasMenu(DesktopModel desk, MenuBuilder menus, CommandWindowModel line)
{
    private IEnumerable<string> StateItems =>
        (desk.Session.Document.Current.Selection.Count > 0 ? MenuLayout.OnSelection : MenuLayout.OnCanvas).Where(name => name.Length == 0 || name.Contains('.', StringComparison.Ordinal) || desk.Session.Catalog.Find(name) is not null);

    /// <param name="room">The available height, units of 1/96 inch; a longer menu scrolls.</param>
    public ContextMenu Make(double room) => new() { Name = "CanvasMenu", MaxHeight = Math.Max(MenuBuilder.MinHeight, room), ItemsSource = Items() };

    private List<Control> Items() => desk.Prompt.Command is null ? [.. RepeatItems(), .. menus.Entries(StateItems)] : [.. CommandItems()];

    private IEnumerable<Control> RepeatItems()
    {
        if (desk.Session.RepeatableCommand is { } last) yield return Item(Text.Get("CanvasMenu.Repeat", last), "CanvasMenu.Repeat", () => _ = desk.Queue.EnterAsync(""));
        if (Recent() is { } recent) yield return recent;
        if (desk.Session.RepeatableCommand is not null || line.Recent.Count > 0) yield return new Separator();
    }

    private IEnumerable<Control> CommandItems()
    {
        yield return Item(Text.Get("CanvasMenu.Enter"), "CanvasMenu.Enter", () => _ = desk.Queue.EnterAsync(""));
        yield return Item(Text.Get("CanvasMenu.Cancel"), "CanvasMenu.Cancel", line.Cancel);
        if (Recent() is { } recent) yield return recent;
        if (desk.Prompt.Options.Count > 0) yield return new Separator();
        foreach (var option in desk.Prompt.Options) yield return Item(EscapeAccessKey(option.Shown), option.Name, () => line.Choose.Execute(option));
    }

    private MenuItem? Recent()
    {
        if (line.Recent.Count == 0) return null;
        var item = new MenuItem { Header = Text.Get("CanvasMenu.Recent"), Tag = "CanvasMenu.Recent" };
        foreach (var input in line.Recent) item.Items.Add(Item(EscapeAccessKey(input), input, () => line.Repeat(input)));
        return item;
    }

    private static MenuItem Item(string header, string tag, Action run) => new() { Header = header, Tag = tag, Command = new RelayCommand(run) };

    /// <summary>Escapes underscores, which would mark an access key.</summary>
    private static string EscapeAccessKey(string text) => text.Replace("_", "__", StringComparison.Ordinal);
}
