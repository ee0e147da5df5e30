using Avalonia.Controls;
using Engraver.App.Menus;
using Engraver.Workbench.Commands;

namespace Engraver.App.Tests.Menus;

[Collection(DesktopCollection.Name)]
public sealed class MenuLayoutTests(DesktopFixture fixture)
{
    [Fact]
    public void Every_command_stands_in_one_menu_and_none_that_is_not_built()
    {
        var catalog = CommandCatalog.Built();
        var shown = MenuLayout.For(catalog).SelectMany(section => section.Entries).Where(entry => entry.Length > 0 && !entry.Contains('.', StringComparison.Ordinal)).ToList();

        Assert.Equal(catalog.All.Select(info => info.Name).Order(StringComparer.Ordinal), shown.Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Separators_stand_between_entries_only()
    {
        foreach (var section in MenuLayout.For(CommandCatalog.Built()))
        {
            Assert.NotEqual("", section.Entries[0]);
            Assert.NotEqual("", section.Entries[^1]);
            Assert.DoesNotContain(("", ""), section.Entries.Zip(section.Entries.Skip(1)));
        }
    }

    [Fact]
    public Task A_menu_opens_and_its_item_runs_the_command() => fixture.WithOperator(here =>
    {
        var machine = here.Find<MenuItem>("MachineMenu");
        here.Click(machine);
        var status = machine.Items.OfType<MenuItem>().Single(item => item.Tag is "CNCSTATUS");
        here.Click(status);
        here.Rest();

        Assert.Contains("OFFLINE", here.History);
    });
}
