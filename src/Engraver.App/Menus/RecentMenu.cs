using Avalonia.Controls;
using Engraver.App.StartPage;
using Engraver.App.Texts;
using ICommand = System.Windows.Input.ICommand;

namespace Engraver.App.Menus;

/// <summary>The submenu of the recent drawings. Missing files are marked and disabled.</summary>
/// <param name="open">Opens a drawing, the parameter.</param>
/// <param name="list">The RECENT command, which lists them in the command window.</param>
public sealed class RecentMenu(RecentDrawings recent, ICommand open, ICommand list)
{
    /// <summary>The menu entry; its drawings are updated whenever it is opened.</summary>
    public MenuItem Entry(object header)
    {
        var item = new MenuItem { Header = header, Tag = "RECENT" };
        Fill(item);
        recent.Changed += () => Fill(item);
        item.SubmenuOpened += (_, _) => recent.Refresh();
        return item;
    }

    private void Fill(MenuItem item)
    {
        item.Items.Clear();
        foreach (var (drawing, at) in recent.All.Select((drawing, at) => (drawing, at))) item.Items.Add(EntryOf(drawing, at + 1));
        if (recent.All.Count > 0) item.Items.Add(new Separator());
        item.Items.Add(new MenuItem { Header = Text.Get("Menu.RecentList"), Command = list });
    }

    private MenuItem EntryOf(RecentDrawing drawing, int number)
    {
        var name = drawing.Name.Replace("_", "__", StringComparison.Ordinal); // a single underscore marks an access key
        var entry = new MenuItem { Header = Text.Get(drawing.IsMissing ? "Menu.RecentNotFound" : "Menu.RecentDrawing", number, name), Command = open, CommandParameter = drawing, IsEnabled = drawing.Exists, Tag = drawing.Path };
        ToolTip.SetTip(entry, drawing.Path);
        return entry;
    }
}
