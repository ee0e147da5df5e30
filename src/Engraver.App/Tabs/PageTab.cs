using Avalonia.Controls;
using Engraver.App.Binding;

namespace Engraver.App.Tabs;

/// <summary>A page behind a tab; created when first shown, so that the first frame does not wait for hidden pages.</summary>
public sealed class PageTab(string key, Func<Control> make) : ObservableObject
{
    private Control? _page;
    private int _pendingCount;

    /// <summary>Name of the page; its title is the text <c>Page.KEY</c>.</summary>
    public string Key => key;

    public string Title { get; } = Texts.Text.Get("Page." + key);

    public bool IsCreated => _page is not null;

    public Control Page => _page ??= make();

    /// <summary>Number of items on the page that wait for the operator; shown on the tab, even before the page is created.</summary>
    public int PendingCount
    {
        get => _pendingCount;
        set
        {
            if (SetProperty(ref _pendingCount, value)) OnPropertyChanged(nameof(HasPending));
        }
    }

    public bool HasPending => PendingCount > 0;
}
