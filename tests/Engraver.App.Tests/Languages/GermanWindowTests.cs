using System.Collections;
using System.Globalization;
using System.Resources;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.LogicalTree;
using Avalonia.VisualTree;
using Engraver.App.Tabs;
using Engraver.App.Texts;
using Engraver.Core.Languages;

namespace Engraver.App.Tests.Languages;

/// <summary>The window in German: no text is cut off or English.</summary>
[Collection(DesktopCollection.Name)]
public sealed class GermanWindowTests(DesktopFixture fixture)
{
    private static readonly CultureInfo s_german = new("de");

    /// <summary>A screen of 1280 x 800 pixels at 100 and at 150 %, in units of the window.</summary>
    public static TheoryData<double, double> Sizes => new() { { 1280, 800 }, { 1280 / 1.5, 800 / 1.5 } };

    [Theory]
    [MemberData(nameof(Sizes))]
    public Task No_text_of_the_window_and_its_pages_is_cut_off(double width, double height) => fixture.WithOperator(here =>
    {
        (here.Window.Width, here.Window.Height) = (width, height);
        var cut = new SortedSet<string>(StringComparer.Ordinal);
        LookAtPages("empty");
        here.Show("Command"); // text typed in the terminal stays there
        here.Open("nameplate.dxf");
        here.WaitUntilIdle();
        LookAtPages("with a drawing");
        Assert.True(cut.Count == 0, string.Join('\n', cut));

        void LookAtPages(string state)
        {
            foreach (var page in Pages(here))
            {
                here.Show(page);
                cut.UnionWith(TextFit.CutOff(here.Window).Select(complaint => $"{page}, {state}: {complaint}"));
            }
        }
    }, language: s_german);

    [Fact]
    public Task No_word_of_the_window_and_its_menus_is_English() => fixture.WithOperator(here =>
    {
        here.Open("nameplate.dxf");
        var shown = new HashSet<string>(Shown(here.Window));
        foreach (var page in Pages(here))
        {
            here.Show(page);
            shown.UnionWith(Shown(here.Window));
        }

        var file = LanguageFile.For(s_german)!;
        var german = file.Texts.Values.ToHashSet();
        var left = English().Where(text => shown.Contains(text.Value) && !german.Contains(text.Value)).Select(text => $"{text.Key}: {text.Value}").ToList();
        Assert.True(left.Count == 0, string.Join('\n', left));
        Assert.InRange(shown.Count(german.Contains), 80, 10000);
    }, language: s_german);

    private static List<string> Pages(Operator here) => [.. here.Window.GetVisualDescendants().OfType<PageTabs>().SelectMany(tabs => tabs.Pages).Select(page => page.Key)];

    /// <summary>The English texts of the desktop.</summary>
    private static IEnumerable<KeyValuePair<string, string>> English()
    {
        var texts = new ResourceManager("Engraver.App.Texts.Texts", typeof(Text).Assembly).GetResourceSet(CultureInfo.InvariantCulture, createIfNotExists: true, tryParents: false)!;
        return texts.Cast<DictionaryEntry>().Select(entry => KeyValuePair.Create((string)entry.Key, (string)entry.Value!));
    }

    private static IEnumerable<string> Shown(Window window) => window.GetVisualDescendants().OfType<Control>()
        .Concat(window.GetVisualDescendants().OfType<Menu>().SelectMany(menu => menu.GetLogicalDescendants().OfType<Control>()))
        .SelectMany(Words).OfType<string>().SelectMany(text => text.Split('\n')).Select(text => text.Replace("_", "", StringComparison.Ordinal));

    private static IEnumerable<object?> Words(Control control) =>
    [
        ToolTip.GetTip(control), AutomationProperties.GetName(control), (control as TextBlock)?.Text, (control as MenuItem)?.Header,
        (control as ContentControl)?.Content, (control as TextBox)?.PlaceholderText,
    ];
}
