using Avalonia;
using Avalonia.Controls;
using Avalonia.Interactivity;
using Avalonia.Media;

namespace Engraver.App.Tabs;

/// <summary>Pages behind a strip of tabs. A page is made when it is first shown and kept.</summary>
public partial class PageTabs : UserControl
{
    public PageTabs() => InitializeComponent();

    /// <summary>Raised when the fold button was pressed; the shell folds or opens the panel.</summary>
    public event EventHandler? FoldWanted;

    /// <summary>A page came to the front.</summary>
    public event EventHandler? PageShown;

    public IReadOnlyList<PageTab> Pages { get; private set; } = [];

    /// <summary>The page in front.</summary>
    public PageTab? Current => Strip.SelectedItem as PageTab;

    /// <param name="first">Key of the page in front.</param>
    public void SetPages(IReadOnlyList<PageTab> pages, string first)
    {
        Pages = pages;
        Strip.ItemsSource = pages;
        Show(first);
    }

    public void Show(string key) => Strip.SelectedItem = Pages.First(page => page.Key == key);

    /// <summary>Shows the pages or, folded, only the strip of tabs; the fold button shows what a click does next.</summary>
    public void ShowFolded(bool folded, string openIcon, string foldIcon)
    {
        Shown.IsVisible = !folded;
        FoldIcon.Data = (Geometry)Application.Current!.FindResource(folded ? openIcon : foldIcon)!;
    }

    /// <summary>Hides the strip of tabs of a panel that is folded sideways.</summary>
    public void HideStrip(bool hidden) => Strip.IsVisible = !hidden;

    private void OnSelected(object? sender, SelectionChangedEventArgs e)
    {
        if (Current is not { } page) return;
        Shown.Content = page.Page;
        PageShown?.Invoke(this, EventArgs.Empty);
    }

    private void OnFold(object? sender, RoutedEventArgs e) => FoldWanted?.Invoke(this, EventArgs.Empty);
}
