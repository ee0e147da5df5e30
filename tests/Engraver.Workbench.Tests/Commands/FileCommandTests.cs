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
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("MOVE", "ALL", "", "0,0", "5,7", "ERASE", "H", "A3", "", "REVERSE", "H", "A1", "", "SAVEAS", "out.dxf");
        var edited = talk.State.Drawing!;
        await talk.TypeAsync("OPEN", "out.dxf");
        var read = talk.State.Drawing!;

        Assert.Empty(read.Diagnostics);
        Assert.Equal(Segments(edited), Segments(read));
        Assert.Equal("mm", read.Unit.Name);
    }

    [Fact]
    public async Task Units_layers_and_colours_are_saved_as_they_are()
    {
        await using var talk = new CommandTestSession();
        var drawing = new DrawingBuilder { Unit = LengthUnits.FromInsUnits(1)! }.Line(0, 0, 1, 0)
            .OnLayer(new Layer("SCHRIFT Ä", On: true, Frozen: false, Plot: true) { Colour = DrawingColour.FromCode62(3) }).Line(0, 0, 0, 2)
            .OnLayer(new Layer("Контур 輪郭 😀", On: true, Frozen: true, Plot: true) { Colour = DrawingColour.FromCode420(0xFF8000) }).Line(0, 0, 3, 0)
            .OnLayer(new Layer("off", On: false, Frozen: false, Plot: false) { Colour = DrawingColour.FromCode62(1) }).Line(0, 0, 3, 3).Build();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = drawing });
        await talk.TypeAsync("SAVEAS", "out.dxf", "OPEN", "out.dxf");

        Assert.Equal(("in", 1.0), (talk.State.Drawing!.Unit.Name, talk.State.Drawing.Parts[0].D));
        Assert.Equal(drawing.Layers, talk.State.Drawing.Layers);
        Assert.Equal([0, 1, 2, 3], Entities(talk.State.Drawing).Select(entity => entity.Layer));
    }

    [Fact]
    public async Task Entities_keep_their_colours_and_what_was_invisible_stays_so()
    {
        await using var talk = new CommandTestSession();
        await File.WriteAllBytesAsync(talk.PathOf("in.dxf"), DxfText.WithEntities(
            (0, "LINE"), (62, 5), (10, 0.0), (20, 0.0), (11, 1.0), (21, 0.0),
            (0, "LINE"), (420, 0x112233), (10, 0.0), (20, 1.0), (11, 1.0), (21, 1.0),
            (0, "LINE"), (60, 1), (10, 0.0), (20, 2.0), (11, 1.0), (21, 2.0)).ToAscii());
        await talk.TypeAsync("OPEN", "in.dxf", "HIDEOBJECTS", "0,1", "", "SAVEAS", "out.dxf", "OPEN", "out.dxf");

        var read = talk.State.Drawing!;
        Assert.Equal([5, null, 7], Enumerable.Range(0, 3).Select(index => read.ColourOf(index).Index));
        Assert.Equal(0x112233u, read.ColourOf(1).Rgb);
        Assert.Equal([false, false, true], Entities(read).Select(entity => entity.Hidden));
    }

    [Fact]
    public async Task Curves_are_saved_as_what_they_are()
    {
        await using var talk = new CommandTestSession();
        var slot = new[] { Segment.FromLine(new(0, 0), new(10, 0)), Arc(10, 2.5, 2.5, -90, 180), Segment.FromLine(new(10, 5), new(0, 5)), Arc(0, 2.5, 2.5, 90, 180) };
        var drawing = new DrawingBuilder().Curve(CurveType.LwPolyline, slot).Circle(3, 3, 1).Arc(0, 0, 7, 350, 20)
            .Curve(CurveType.LwPolyline, Segment.FromLine(new(0, 0), new(3, 1)), Segment.FromLine(new(3, 1), new(3, 5)))
            .Free(FreeCurves.Spline(3, [new(0, 0), new(1, 2), new(3, 2), new(4, 0)], [1, 2, 1, 1]))
            .Free(new EllipseArc(new(3, 4, 0), new(5, 0, 0), new(0, 2, 0), Angle.FromDegrees(20), Angle.FromDegrees(200)).ToCurve()).Build();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = drawing });
        await talk.TypeAsync("SAVEAS", "out.dxf", "OPEN", "out.dxf");

        var read = talk.State.Drawing!;
        Assert.Empty(read.Diagnostics);
        Assert.Equal(Entities(drawing).Select(entity => (entity.Type, entity.PartCount)), Entities(read).Select(entity => (entity.Type, entity.PartCount)));
        foreach (var (before, after) in Segments(drawing).Zip(Segments(read)))
        {
            Assert.Equal(before.Kind, after.Kind);
            Assert.Equal(before.Length, after.Length, 1e-9);
            Assert.True(before.Start.IsNear(after.Start, 1e-9) && before.End.IsNear(after.End, 1e-9));
        }
    }

    [Theory]
    [MemberData(nameof(SampleDrawings))]
    public async Task Every_sample_comes_back_from_saveas(string sample)
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample(sample));
        var before = talk.State.Drawing!;
        await talk.TypeAsync("SAVEAS", "out.dxf", "OPEN", "out.dxf");
        var after = talk.State.Drawing!;

        Assert.Equal(before.Parts.Count, after.Parts.Count);
        Assert.Equal(before.Layers, after.Layers);
        Assert.Equal(before.Unit.MillimetresPerUnit, after.Unit.MillimetresPerUnit);
        foreach (var (old, read) in Segments(before).Zip(Segments(after))) Assert.Equal((old.Kind, 1.0), (read.Kind, Math.Round(read.Length / old.Length, 9)));
    }

    public static TheoryData<string> SampleDrawings => [.. Directory.GetFiles(RepositoryFolder.Samples, "*.dxf").Select(file => Path.GetFileName(file))];

    [Fact]
    public async Task A_file_that_is_there_is_replaced_only_when_that_is_said()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await File.WriteAllTextAsync(talk.PathOf("out.dxf"), "precious");

        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SAVEAS", "out.dxf", ""));
        Assert.Equal("precious", await File.ReadAllTextAsync(talk.PathOf("out.dxf")));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("SAVEAS", "out.dxf", "Y"));
        Assert.StartsWith("0\nSECTION", await File.ReadAllTextAsync(talk.PathOf("out.dxf")), StringComparison.Ordinal);
    }

    /// <summary>At the command line an existing file is not overwritten without a question; a script overwrites its results.</summary>
    [Theory]
    [InlineData("POST Galil", "out.dmc")]
    [InlineData("PLOT Path", "out.svg")]
    [InlineData("TABLE Sequenced Csv", "out.csv")]
    [InlineData("AGIEPOST Exact", "out.agie")]
    [InlineData("EXPORT", "out.svg")]
    [InlineData("REPORT", "out.html")]
    public async Task A_result_replaces_a_file_only_when_that_is_said(string command, string name)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await File.WriteAllTextAsync(talk.PathOf(name), "precious");
        string[] inputs = [.. command.Split(' '), name];

        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync(inputs));
        Assert.StartsWith($"{name} already exists. Replace it? [Yes/No] <No>", talk.Session.Prompt.Text, StringComparison.Ordinal);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync(""));
        Assert.Equal("precious", await File.ReadAllTextAsync(talk.PathOf(name)));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync([.. inputs, "Yes"]));
        Assert.NotEqual("precious", await File.ReadAllTextAsync(talk.PathOf(name)));
    }

    [Theory]
    [InlineData("POST Galil", "out.dmc")]
    [InlineData("PLOT Path", "out.svg")]
    [InlineData("TABLE Sequenced Csv", "out.csv")]
    public async Task A_script_writes_its_results_anew_without_a_question(string command, string name)
    {
        await using var talk = CommandTestSession.WithDrawing();
        await File.WriteAllTextAsync(talk.PathOf(name), "old");
        await File.WriteAllTextAsync(talk.PathOf("again.scr"), $"{command} {name}\nZOOM E\n");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("SCRIPT", "again.scr"));
        Assert.NotEqual("old", await File.ReadAllTextAsync(talk.PathOf(name)));
    }

    [Fact]
    public async Task What_the_console_cuts_with_an_option_the_commands_open_with_a_setting()
    {
        await using var talk = new CommandTestSession();
        await File.WriteAllBytesAsync(talk.PathOf("solid.dxf"), DxfText.WithEntities(
            (0, "SOLID"), (10, 0.0), (20, 0.0), (11, 4.0), (21, 0.0), (12, 0.0), (22, 3.0), (13, 4.0), (23, 3.0)).ToAscii());
        await talk.TypeAsync("OPEN", "solid.dxf");
        Assert.Equal(0, talk.State.Drawing!.Entities.Count);

        await talk.TypeAsync("CNCCUT", "16", "OPEN", "solid.dxf");
        Assert.Equal(CurveType.Solid, Assert.Single(Entities(talk.State.Drawing!)).Type);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRECOVER", "1"));
        Assert.True(talk.State.Settings.RecoverArcs);
    }

    [Theory]
    [InlineData("a.csv", "gasket.table.csv")]
    [InlineData("a.svg", "gasket.path.svg")]
    [InlineData("a.dmc", "gasket.galil.dmc")]
    public async Task Export_writes_what_the_ending_says(string name, string golden)
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "EXPORT", name);

        Assert.Equal(await File.ReadAllTextAsync(CommandTestSession.Sample(Path.Combine("expected", golden))), await File.ReadAllTextAsync(talk.PathOf(name)));
    }

    [Fact]
    public async Task Export_to_dxf_is_the_path_in_order_and_an_unknown_ending_is_said()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"), "EXPORT", "cl.dxf");
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("EXPORT", "a.xyz"));

        Assert.Contains("RAPID", await File.ReadAllTextAsync(talk.PathOf("cl.dxf")), StringComparison.Ordinal);
        Assert.False(File.Exists(talk.PathOf("a.xyz")));
    }

    [Fact]
    public async Task Recent_needs_something_that_was_opened()
    {
        await using var talk = new CommandTestSession();

        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("RECENT"));
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("RECENT", ""));
        Assert.Contains(" 1  ", talk.Said, StringComparison.Ordinal);
    }

    private static Segment Arc(double x, double y, double radius, double start, double sweep) => Segment.FromArc(new ArcSegment(new(x, y), radius, Angle.FromDegrees(start), Angle.FromDegrees(sweep)));

    private static DrawingEntity[] Entities(Drawing drawing) => [.. Enumerable.Range(0, drawing.Entities.Count).Select(index => drawing.Entities[index])];

    private static IEnumerable<Segment> Segments(Drawing drawing) => Enumerable.Range(0, drawing.Parts.Count).Select(part => drawing.SegmentOf(drawing.Parts[part]));
}
