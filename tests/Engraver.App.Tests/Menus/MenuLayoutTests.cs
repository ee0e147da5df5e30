using System.Globalization;
using Avalonia.Controls;
using Avalonia.VisualTree;
using Engraver.App.Menus;
using Engraver.App.Tests.Shell;
using Engraver.Workbench.Commands;

namespace Engraver.App.Tests.Menus;

[Collection(DesktopCollection.Name)]
public sealed class MenuLayoutTests(DesktopFixture fixture)
{
    [Fact]
    public void Every_command_stands_in_one_menu_and_none_that_is_not_built()
    {
        var catalog = CommandCatalog.Built();
        var shown = MenuLayout.For(catalog).SelectMany(section => section.Commands).ToList();

        Assert.Equal(catalog.All.Select(info => info.Name).Order(StringComparer.Ordinal), shown.Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Separators_stand_between_entries_only()
    {
        foreach (var section in MenuLayout.For(CommandCatalog.Built()).SelectMany(menu => menu.Submenus.Prepend(menu)).Where(menu => menu.Entries.Count > 0))
        {
            Assert.NotEqual("", section.Entries[0]);
            Assert.NotEqual("", section.Entries[^1]);
            Assert.DoesNotContain(("", ""), section.Entries.Zip(section.Entries.Skip(1)));
        }
    }

    /// <summary>On a screen of 1280 x 720 pixels at 150 % all menus and submenus fit without scrolling.</summary>
    [Theory]
    [InlineData("en")]
    [InlineData("de")]
    public Task Every_menu_fits_into_a_low_window(string language) => fixture.WithOperator(here =>
    {
        LayoutTests.LookAt(here, 1280, 720, 1.5);
        var scrolled = new List<string>();
        foreach (var menu in here.Find<Menu>("MainMenu").Items.OfType<MenuItem>().ToList())
        {
            here.Click(menu);
            Look(menu, scrolled);
            foreach (var submenu in menu.Items.OfType<MenuItem>().Where(item => item.ItemCount > 0).ToList())
            {
                submenu.Open();
                here.Step();
                Look(submenu, scrolled);
                submenu.Close();
            }

            menu.Close();
            here.Step();
        }

        Assert.True(scrolled.Count == 0, string.Join('\n', scrolled));
        here.Hands.SetScale(1.0);
    }, language: new CultureInfo(language));

    private static void Look(MenuItem menu, List<string> scrolled)
    {
        var list = menu.Items.OfType<MenuItem>().First().GetVisualAncestors().OfType<ScrollViewer>().First();
        if (list.Extent.Height > list.Viewport.Height + 0.5) scrolled.Add(FormattableString.Invariant($"{menu.Name ?? menu.Tag} is {list.Extent.Height:0} high and has {list.Viewport.Height:0}"));
    }

    [Fact]
    public Task A_menu_opens_and_its_item_runs_the_command() => fixture.WithOperator(here =>
    {
        var machine = here.Find<MenuItem>("MachineMenu");
        here.Click(machine);
        var status = machine.Items.OfType<MenuItem>().Single(item => item.Tag is "CNCSTATUS");
        here.Click(status);
        here.WaitUntilIdle();

        Assert.Contains("OFFLINE", here.History);
    });
}
