using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Layout;
using Avalonia.VisualTree;
using Engraver.App.Texts;
using ICommand = System.Windows.Input.ICommand;

namespace Engraver.App.Menus;

/// <summary>Creates the menus of the layout. The items of a menu are created when it is first opened.</summary>
/// <param name="typed">Returns the text that is typed for a command; it is shown at the right of the entry.</param>
/// <param name="commandOf">Returns the command of an entry.</param>
/// <param name="recent">The submenu of RECENT; null: the entry runs the command.</param>
public sealed class MenuBuilder(Func<string, string> typed, Func<string, ICommand> commandOf, RecentMenu? recent = null)
{
    /// <summary>Minimum height of a menu, units of 1/96 inch.</summary>
    internal const double MinHeight = 120;

    /// <summary>Between a menu and the edge of its window.</summary>
    private const double Edge = 8;

    public IReadOnlyList<MenuItem> Build(IEnumerable<MenuSection> sections) => [.. sections.Where(section => section.Entries.Count > 0).Select(Menu)];

    /// <summary>Limits the height of an open menu to that of its window; a longer menu scrolls.</summary>
    public static void Fit(MenuItem? item, Visual window)
    {
        if (item?.GetVisualDescendants().OfType<Popup>().FirstOrDefault() is not { Child: Border list } || item.TranslatePoint(default, window) is not { } corner) return;
        var top = item.Parent is Menu ? corner.Y + item.Bounds.Height : 0;
        list.MaxHeight = Math.Max(MinHeight, window.Bounds.Height - top - Edge);
    }

    private MenuItem Menu(MenuSection section)
    {
        var item = new MenuItem { Header = Text.Get("Menu." + section.Key), Name = section.Key + "Menu", Tag = section.Name };
        item.Items.Add(new MenuItem());
        item.SubmenuOpened += Fill;
        return item;

        void Fill(object? sender, EventArgs e)
        {
            item.SubmenuOpened -= Fill;
            item.Items.Clear();
            foreach (var name in section.Entries) item.Items.Add(section.Submenus.FirstOrDefault(submenu => submenu.Name == name) is { } submenu ? Menu(submenu) : Entry(name));
        }
    }

    /// <summary>Items for entries of a layout.</summary>
    public IEnumerable<Control> Entries(IEnumerable<string> names) => names.Select(Entry);

    private Control Entry(string name)
    {
        if (name.Length == 0) return new Separator();
        var isCommand = !name.Contains('.', StringComparison.Ordinal);
        var row = new Grid { ColumnDefinitions = new ColumnDefinitions("*,Auto"), MinWidth = 210 };
        row.Children.Add(new TextBlock { Text = isCommand ? MenuTitle.Find(name) : Text.Get(name), VerticalAlignment = VerticalAlignment.Center });
        if (isCommand) row.Children.Add(Hint(typed(name)));
        if (name == "RECENT" && recent is not null) return recent.Entry(row);
        return new MenuItem { Header = row, Command = commandOf(name), Tag = name };
    }

    private static TextBlock Hint(string text)
    {
        var hint = new TextBlock { Text = text, Margin = new Thickness(24, 0, 0, 0), VerticalAlignment = VerticalAlignment.Center, FontSize = 11, Classes = { "quiet" } };
        Grid.SetColumn(hint, 1);
        return hint;
    }
}
