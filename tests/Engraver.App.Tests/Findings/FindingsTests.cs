using Avalonia.Controls;

namespace Engraver.App.Tests.Findings;

[Collection(DesktopCollection.Name)]
public sealed class FindingsTests(DesktopFixture fixture)
{
    [Fact]
    public Task A_click_on_a_finding_goes_to_its_place() => fixture.WithOperator(here =>
    {
        here.Open("clock-dial.dxf");
        here.Show("Findings");
        var list = here.Find<ListBox>("FindingList");
        Assert.NotEqual(0, list.ItemCount);
        var before = here.Commands.View.Current.Height;
        here.Click(list.ContainerFromIndex(0)!);

        Assert.NotNull(here.Commands.View.Current.Focus);
        Assert.True(here.Commands.View.Current.Height < before);
    });
}
