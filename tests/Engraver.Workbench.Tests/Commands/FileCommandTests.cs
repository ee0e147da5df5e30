using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

public class FileCommandTests
{
    [Fact]
    public async Task What_is_saved_reads_back_as_it_was_edited()
    {
        await using var talk = CommandTalk.WithDrawing();
        await talk.TypeAsync("MOVE", "ALL", "", "0,0", "5,7", "ERASE", "H", "A3", "", "REVERSE", "H", "A1", "", "SAVEAS", "out.dxf");
        var edited = talk.State.Drawing!;
        await talk.TypeAsync("OPEN", "out.dxf");
        var read = talk.State.Drawing!;

        Assert.Empty(read.Diagnostics);
        Assert.Equal(Segments(edited), Segments(read));
        Assert.Equal("mm", read.Unit.Name);
    }

    [Fact]
    public async Task An_inch_drawing_is_saved_in_millimetres_and_layers_keep_what_they_mean()
    {
        await using var talk = new CommandTalk();
        var drawing = new DrawingBuilder { Unit = LengthUnits.FromInsUnits(1)! }.Line(0, 0, 1, 0)
            .OnLayer(new Layer("SCHRIFT Ä", On: true, Frozen: false, Plot: true)).Line(0, 0, 0, 2)
            .OnLayer(new Layer("off", On: false, Frozen: false, Plot: true)).Line(0, 0, 3, 3).Build();
        talk.Session.Document.Take("OPEN", new DocumentState { Drawing = drawing });
        await talk.TypeAsync("SAVEAS", "out.dxf", "OPEN", "out.dxf");

        Assert.Equal(25.4, talk.State.Drawing!.Parts[0].D, precision: 9);
        Assert.Equal(["0", "SCHRIFT__", "off"], talk.State.Drawing.Layers.Select(layer => layer.Name).Order(StringComparer.Ordinal));
        Assert.Equal([false], talk.State.Drawing.Layers.Where(layer => layer.Name == "off").Select(layer => layer.CutByDefault));
    }

    [Fact]
    public async Task A_file_that_is_there_is_replaced_only_when_that_is_said()
    {
        await using var talk = CommandTalk.WithDrawing();
        await File.WriteAllTextAsync(talk.PathOf("out.dxf"), "precious");

        Assert.IsType<FeedResult.Failed>(await talk.TypeAsync("SAVEAS", "out.dxf", ""));
        Assert.Equal("precious", await File.ReadAllTextAsync(talk.PathOf("out.dxf")));
        Assert.IsType<FeedResult.Done>(await talk.TypeAsync("SAVEAS", "out.dxf", "Y"));
        Assert.StartsWith("0\nSECTION", await File.ReadAllTextAsync(talk.PathOf("out.dxf")), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_drawing_with_splines_is_not_saved_as_something_else()
    {
        await using var talk = new CommandTalk();
        talk.Session.Document.Take("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 1, 0).Free(FreeCurves.Spline(3, [new(0, 0), new(1, 2), new(3, 2), new(4, 0)], [1, 1, 1, 1])).Build() });

        Assert.Equal(CommandFailure.Drawing, Assert.IsType<FeedResult.Failed>(await talk.TypeAsync("SAVEAS")).Why);
    }

    [Theory]
    [InlineData("a.csv", "gasket.table.csv")]
    [InlineData("a.svg", "gasket.path.svg")]
    [InlineData("a.dmc", "gasket.galil.dmc")]
    public async Task Export_writes_what_the_ending_says(string name, string golden)
    {
        await using var talk = new CommandTalk();
        await talk.TypeAsync("OPEN", CommandTalk.Sample("gasket.dxf"), "EXPORT", name);

        Assert.Equal(await File.ReadAllTextAsync(CommandTalk.Sample(Path.Combine("expected", golden))), await File.ReadAllTextAsync(talk.PathOf(name)));
    }

    [Fact]
    public async Task Export_to_dxf_is_the_path_in_order_and_an_unknown_ending_is_said()
    {
        await using var talk = new CommandTalk();
        await talk.TypeAsync("OPEN", CommandTalk.Sample("gasket.dxf"), "EXPORT", "cl.dxf");
        Assert.IsType<FeedResult.Failed>(await talk.TypeAsync("EXPORT", "a.xyz"));

        Assert.Contains("RAPID", await File.ReadAllTextAsync(talk.PathOf("cl.dxf")), StringComparison.Ordinal);
        Assert.False(File.Exists(talk.PathOf("a.xyz")));
    }

    [Fact]
    public async Task Recent_needs_something_that_was_opened()
    {
        await using var talk = new CommandTalk();

        Assert.IsType<FeedResult.Failed>(await talk.TypeAsync("RECENT"));
        await talk.TypeAsync("OPEN", CommandTalk.Sample("gasket.dxf"));
        Assert.IsType<FeedResult.Done>(await talk.TypeAsync("RECENT", ""));
        Assert.Contains(" 1  ", talk.Said, StringComparison.Ordinal);
    }

    private static IEnumerable<Segment> Segments(Drawing drawing) => Enumerable.Range(0, drawing.Parts.Count).Select(part => drawing.SegmentOf(drawing.Parts[part]));
}
