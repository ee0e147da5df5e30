using Avalonia;
using Avalonia.Controls;
using Engraver.App.Tables;
using Engraver.Core.EntityTables;
using Engraver.TestKit;

namespace Engraver.App.Tests.Tables;

[Collection(DesktopCollection.Name)]
public sealed class TableTests(DesktopFixture fixture)
{
    private const int Million = 1_000_000;

    [Fact]
    public Task A_million_rows_need_a_handful_of_controls() => fixture.WithOperator(here =>
    {
        here.Show("Table");
        var list = here.Find<ListBox>("RowList");
        ((TableModel)list.DataContext!).Show(TableOf(Million));
        here.Step();
        Assert.Equal(Million, list.ItemCount);
        var first = list.GetRealizedContainers().Count();

        list.ScrollIntoView(Million - 1);
        here.Step();
        here.Step();

        Assert.InRange(first, 3, 40);
        Assert.InRange(list.GetRealizedContainers().Count(), 3, 40);
        Assert.Equal(Million - 1, list.GetRealizedContainers().Max(list.IndexFromContainer));
    });

    [Fact]
    public Task The_wheel_scrolls_the_rows_and_the_names_stay() => fixture.WithOperator(here =>
    {
        here.Open("clock-dial.dxf");
        here.Show("Table");
        var list = here.Find<ListBox>("RowList");
        here.Hands.Wheel(here.MiddleOf(list), new Vector(0, -10));
        here.Step();

        Assert.True(list.GetRealizedContainers().Min(list.IndexFromContainer) > 0);
        Assert.True(here.Find<SlotCells>("Names").IsEffectivelyVisible);
    });

    [Fact]
    public void A_row_shows_its_slots_with_a_point()
    {
        var row = new TableRow(TableOf(2), 1);

        Assert.Equal("1", row.Figure(EntitySlot.Kind));
        Assert.Equal("1.25", row.Figure(EntitySlot.StartX));
        Assert.Equal(new TableRow(TableOf(2), 1), row);
        Assert.StartsWith("2: 1 1.25 ", row.ToString(), StringComparison.Ordinal);
    }

    private static EntityTable TableOf(int lines)
    {
        var drawing = new DrawingBuilder();
        for (var i = 0; i < lines; i++) drawing.Line(i * 1.25, 0, (i * 1.25) + 1, 1);
        return EntityTableBuilder.Build(drawing.Build(), new LayerSelection([], []));
    }
}
