using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.TestKit;

namespace Engraver.Core.Tests.EntityTables;

public class EntityTableBuilderTests
{
    private static readonly Layer Off = new("Off", On: false, Frozen: false, Plot: true);
    private static readonly Layer Frozen = new("Frozen", On: true, Frozen: true, Plot: true);
    private static readonly Layer NoPlot = new("NoPlot", On: true, Frozen: false, Plot: false);

    [Fact]
    public void Inches_become_millimetres_in_every_length_and_in_no_angle()
    {
        var drawing = new DrawingBuilder { Unit = new LengthUnit(1, "in", "INSUNITS", 25.4) }.Line(1, 2, 3, 4).Arc(1, 0, 2, 30, 60).Build();

        var table = EntityTableBuilder.Build(drawing, LayerSelection.Default);

        Assert.Equal((new Point2D(25.4, 2 * 25.4), new Point2D(3 * 25.4, 4 * 25.4)), (table[0].StartPoint, table[0].EndPoint));
        Assert.Equal((new Point2D(25.4, 0), 50.8, 30.0, 60.0), (table[1].Centre, table[1].Radius, table[1].StartAngle.Degrees, table[1].EndAngle.Degrees));
    }

    [Fact]
    public void A_polyline_is_taken_apart_and_every_row_knows_its_entity()
    {
        var table = EntityTableBuilder.Build(new DrawingBuilder().Line(0, 0, 1, 0).Square(0, 0, 10).Build(), LayerSelection.Default);

        Assert.Equal([0, 1, 1, 1, 1], Enumerable.Range(0, table.Count).Select(table.EntityIndexOf));
    }

    [Fact]
    public void Layers_that_are_off_frozen_or_not_plotted_stay_out_by_default() =>
        Assert.Equal([0], EntitiesOf(LayerSelection.Default));

    [Fact]
    public void A_named_layer_is_cut_alone_even_when_it_is_off() =>
        Assert.Equal([1], EntitiesOf(new LayerSelection(["OFF"], [])));

    [Fact]
    public void A_skipped_layer_stays_out() =>
        Assert.Empty(EntitiesOf(new LayerSelection([], ["0"])));

    [Fact]
    public void A_hidden_entity_is_not_cut_on_a_visible_layer()
    {
        var table = EntityTableBuilder.Build(new DrawingBuilder().Line(0, 0, 1, 0).Hidden().Line(0, 0, 2, 0).Build(), LayerSelection.Default);

        Assert.Equal(1, table.Count);
    }

    [Fact]
    public void Unknown_layer_names_are_answered_once_each() =>
        Assert.Equal(["Holes", "Text"], new LayerSelection(["Holes", "off"], ["Text", "HOLES"]).UnknownNames([Off]));

    [Fact]
    public void Rows_beyond_the_first_chunk_read_back()
    {
        var builder = new DrawingBuilder();
        for (var i = 0; i < 10_000; i++) builder.Line(i, 0, i, 1);

        var table = EntityTableBuilder.Build(builder.Build(), LayerSelection.Default);

        Assert.All([0, 4095, 4096, 9999], row => Assert.Equal(row, table[row].StartPoint.X));
    }

    private static IEnumerable<int> EntitiesOf(LayerSelection selection)
    {
        var drawing = new DrawingBuilder().Line(0, 0, 1, 0).OnLayer(Off).Line(0, 0, 2, 0).OnLayer(Frozen).Line(0, 0, 3, 0).OnLayer(NoPlot).Line(0, 0, 4, 0).Build();
        var table = EntityTableBuilder.Build(drawing, selection);
        return Enumerable.Range(0, table.Count).Select(table.EntityIndexOf);
    }
}
