using System.Globalization;
using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.LogicalTree;
using Avalonia.VisualTree;
using Engraver.App.Tabs;
using Engraver.Core.Languages;
using Engraver.TestKit;

namespace Engraver.App.Tests.Languages;

/// <summary>The window in the pseudo-language. A plain letter outside of marks is a text that cannot be translated.</summary>
[Collection(DesktopCollection.Name)]
public sealed class PseudoLanguageTests(DesktopFixture fixture)
{
    /// <summary>The texts of Avalonia's scroll bar for a screen reader.</summary>
    private static readonly string[] s_scrollBar = ["Line", "Page", "Position", "up", "down"];

    /// <summary>Names of commands, work origins and units, which are the same in every language.</summary>
    private static readonly string[] s_stays = ["mm", "s", "x", "SNAP", "GRID", "ORTHO", "POLAR", "OSNAP", "DYN", "G", .. s_scrollBar];

    [Fact]
    public Task Every_word_of_the_window_and_its_pages_is_in_the_language() => fixture.WithOperator(op =>
    {
        var shown = new HashSet<string>();
        shown.UnionWith(Shown(op.Window));
        foreach (var tabs in op.Window.GetVisualDescendants().OfType<PageTabs>().ToList())
        {
            foreach (var page in tabs.Pages.ToList())
            {
                op.Show(page.Key);
                shown.UnionWith(Shown(op.Window));
            }
        }

        var wrong = shown.Where(text => PseudoLanguage.UnmarkedWords(text).Except(s_stays).Any() || HiddenSentence.IsIn(text)).Order(StringComparer.Ordinal).ToList();
        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
        Assert.InRange(shown.Count(text => text.Contains('⟦', StringComparison.Ordinal)), 100, 10000);
    }, language: new CultureInfo(PseudoLanguage.CultureName));

    private static IEnumerable<string> Shown(Visual window) => window.GetVisualDescendants().OfType<Control>()
        .Concat(window.GetVisualDescendants().OfType<Menu>().SelectMany(menu => menu.GetLogicalDescendants().OfType<Control>()))
        .SelectMany(Words).OfType<string>().SelectMany(text => text.Split('\n'));

    private static IEnumerable<object?> Words(Control control) =>
    [
        ToolTip.GetTip(control), AutomationProperties.GetName(control), (control as TextBlock)?.Text, (control as MenuItem)?.Header,
        (control as ContentControl)?.Content, (control as TextBox)?.PlaceholderText, (control as TextBox)?.Text,
    ];
}
