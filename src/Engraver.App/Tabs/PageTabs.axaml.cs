using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Media;
using Engraver.App.Binding;

namespace Engraver.App.Tabs;

/// <summary>Pages behind a strip of tabs. A page is created when first shown, and kept.</summary>
public partial class PageTabs : UserControl
{
    private Control? _visiblePage;

    public PageTabs()
    {
        InitializeComponent();
        Strip.AddHandler(PointerReleasedEvent, OnTabClick, RoutingStrategies.Tunnel | RoutingStrategies.Bubble, handledEventsToo: true);
    }

    /// <summary>Raised when the fold button was pressed, or a tab of a folded panel; the shell folds or opens the panel.</summary>
    public event EventHandler? FoldRequested;

    /// <summary>The page in front asked for more room, or for the usual room again.</summary>
    public event EventHandler? WidenRequested;

    /// <summary>A page came to the front.</summary>
    public event EventHandler? PageShown;

    public IReadOnlyList<PageTab> Pages { get; private set; } = [];

    /// <summary>The page in front.</summary>
    public PageTab? Current => Strip.SelectedItem as PageTab;

    /// <summary>Only the strip of tabs, or the title of the page in front, is visible.</summary>
    public bool IsFolded => !Shown.IsVisible;

    /// <param name="first">Key of the page in front.</param>
    public void SetPages(IReadOnlyList<PageTab> pages, string first)
    {
        Pages = pages;
        Strip.ItemsSource = pages;
        Show(first);
    }

    public void Show(string key) => Strip.SelectedItem = Pages.First(page => page.Key == key);

    /// <summary>Called by a page that needs more room, or no longer needs it.</summary>
    public void RequestWiden() => WidenRequested?.Invoke(this, EventArgs.Empty);

    /// <summary>Shows the pages or, folded, only the strip of tabs; the fold button shows what a click does next.</summary>
    public void ShowFolded(bool folded, string openIcon, string foldIcon)
    {
        Shown.IsVisible = !folded;
        SetVisiblePage(_visiblePage);
        FoldIcon.Data = (Geometry)Application.Current!.FindResource(folded ? openIcon : foldIcon)!;
    }

    /// <summary>Hides the strip of tabs of a panel that is folded sideways; the rotated title of the page in front replaces it.</summary>
    public void HideStrip(bool hidden) => (Strip.IsVisible, FoldedTitle.IsVisible) = (!hidden, hidden);

    /// <summary>Shows a line over the page in front; empty hides it.</summary>
    public void Hint(string text) => (HintText.Text, HintText.IsVisible) = (text, text.Length > 0 && Shown.IsVisible);

    private void OnSelected(object? sender, SelectionChangedEventArgs e)
    {
        if (Current is not { } page) return;
        Shown.Content = page.Page;
        FoldedText.Text = page.Title;
        SetVisiblePage(page.Page);
        PageShown?.Invoke(this, EventArgs.Empty);
    }

    /// <summary>Notifies the page in front that it is visible, unless the panel is folded, and the previous page that it is not.</summary>
    private void SetVisiblePage(Control? page)
    {
        if (!ReferenceEquals(page, _visiblePage) && _visiblePage?.DataContext is IVisibilityAware hidden) hidden.IsPageVisible = false;
        _visiblePage = page;
        if (page?.DataContext is IVisibilityAware shown) shown.IsPageVisible = Shown.IsVisible;
    }

    private void OnTabClick(object? sender, PointerReleasedEventArgs e)
    {
        if (!IsFolded || e.Handled || (e.Source as Control)?.DataContext is not PageTab) return;
        e.Handled = true;
        FoldRequested?.Invoke(this, EventArgs.Empty);
    }

    private void OnFold(object? sender, RoutedEventArgs e) => FoldRequested?.Invoke(this, EventArgs.Empty);
}
