using Avalonia.Controls;

namespace Engraver.App.Tabs;

/// <summary>A page behind a tab; made when it is first shown, because the first frame must not wait for pages nobody looks at.</summary>
public sealed class PageTab(string key, Func<Control> make)
{
    private Control? _page;

    /// <summary>Name of the page; its title is the text <c>Page.KEY</c>.</summary>
    public string Key => key;

    public string Title { get; } = Texts.Text.Of("Page." + key);

    public bool IsMade => _page is not null;

    public Control Page => _page ??= make();
}
