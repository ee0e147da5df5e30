using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>Objects on a locked layer are shown, cut and copied, but not changed by any command, as in AutoCAD.</summary>
public sealed class LockedLayerTests
{
    /// <summary>The first line on layer 0; a line that crosses it, and one that meets its end, on a layer that the file locks (70 bit 4).</summary>
    private static readonly (int, object)[] s_entities =
    [
        (0, "LINE"), (5, "A1"), (8, "0"), (10, 0.0), (20, 0.0), (11, 10.0), (21, 0.0),
        (0, "LINE"), (5, "A2"), (8, "FIXED"), (10, 5.0), (20, -5.0), (11, 5.0), (21, 5.0),
        (0, "LINE"), (5, "A3"), (8, "FIXED"), (10, 10.0), (20, 0.0), (11, 10.0), (21, 8.0),
    ];

    private static readonly (int, object)[] s_layers =
    [
        (0, "TABLE"), (2, "LAYER"), (70, 2),
        (0, "LAYER"), (2, "0"), (70, 0), (62, 7), (6, "CONTINUOUS"),
        (0, "LAYER"), (2, "FIXED"), (70, 4), (62, 1), (6, "CONTINUOUS"),
        (0, "ENDTAB"),
    ];

    [Theory]
    [InlineData("ERASE", "ALL", "")]
    [InlineData("MOVE", "ALL", "", "0,0", "3,3")]
    [InlineData("ROTATE", "ALL", "", "0,0", "90")]
    [InlineData("SCALE", "ALL", "", "0,0", "2")]
    [InlineData("MIRROR", "ALL", "", "0,0", "0,1", "Yes")]
    [InlineData("REVERSE", "ALL", "")]
    [InlineData("CHPROP", "ALL", "", "LAyer", "FIXED")]
    [InlineData("STRETCH", "20,20", "-20,-20", "", "0,0", "1,1")]
    [InlineData("TRIM", "", "Crossing", "4,1", "12,6", "")]
    [InlineData("TRIM", "", "eRase", "ALL", "", "")]
    [InlineData("MATCHPROP", "2,0", "20,20", "-20,-20", "")]
    public async Task Commands_take_the_rest_and_say_how_many_are_locked(params string[] inputs)
    {
        await using var talk = await OpenAsync();
        var before = Locked(talk);

        await talk.TypeAsync(inputs);

        Assert.Equal(before, Locked(talk));
        Assert.Contains("On a locked layer and not changed: 2.", talk.Said, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("ERASE", "5,4", "")]
    [InlineData("BREAK", "5,4", "5,2")]
    [InlineData("FILLET", "2,0", "10,6")]
    [InlineData("FILLET", "10,6", "2,0")]
    [InlineData("EXPLODE", "5,4", "")]
    public async Task A_single_object_on_a_locked_layer_is_refused(params string[] inputs)
    {
        await using var talk = await OpenAsync();
        var before = talk.State.Drawing;

        await talk.TypeAsync(inputs);

        Assert.Same(before, talk.State.Drawing);
        Assert.Contains("Unlock the layer with LAYER", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task They_are_copied_and_are_edges_and_have_no_grips()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("COPY", "5,4", "", "0,0", "20,0", "");
        Assert.Equal(4, talk.State.Drawing!.Entities.Count);
        await talk.TypeAsync("TRIM", "", "2,0", "");
        Assert.Equal(5.0, talk.State.Drawing!.Parts[talk.State.Drawing.Entities[0].FirstPart].InPlan().Start.X);
        await talk.TypeAsync("SELECT", "10,6", "", "GRIPEDIT");
        Assert.Contains("On a locked layer and not changed: 1.", talk.Said, StringComparison.Ordinal);
        Assert.Equal("Command:", talk.Session.Prompt.Text.Trim());
    }

    /// <summary>Texts and points cannot be selected: those on a locked layer are kept when everything is erased or moved, are copied, and move with the whole
    /// drawing.</summary>
    [Fact]
    public async Task Texts_and_points_of_a_locked_layer_stay()
    {
        await using var talk = new CommandTestSession();
        var entities = new (int, object)[] { (0, "LINE"), (5, "A1"), (8, "0"), (10, 0.0), (20, 0.0), (11, 10.0), (21, 0.0), (0, "TEXT"), (8, "FIXED"), (10, 2.0), (20, 1.0), (40, 2.0), (1, "stays"), (0, "POINT"), (8, "FIXED"), (10, 3.0), (20, 2.0) };
        await File.WriteAllBytesAsync(talk.PathOf("in.dxf"), new DxfText().Header("AC1015", 4).Section("TABLES", s_layers).Section("ENTITIES", entities).End().ToAscii());
        await talk.TypeAsync("OPEN", "in.dxf", "MOVE", "ALL", "", "0,0", "5,5");
        Assert.Equal((2.0, 3.0), (talk.State.Drawing!.Texts[0].Position.X, talk.State.Drawing.Points[0].Position.X));
        await talk.TypeAsync("U", "ERASE", "ALL", "");
        Assert.Equal((0, 1, 1), (talk.State.Drawing!.Entities.Count, talk.State.Drawing.Texts.Count, talk.State.Drawing.Points.Count));
        await talk.TypeAsync("U", "COPY", "ALL", "", "0,0", "5,5", "");
        Assert.Equal((2, 2, 2), (talk.State.Drawing!.Entities.Count, talk.State.Drawing.Texts.Count, talk.State.Drawing.Points.Count));
        await talk.TypeAsync("U", "ORIGIN", "1,1");
        Assert.Equal((1.0, 2.0), (talk.State.Drawing!.Texts[0].Position.X, talk.State.Drawing.Points[0].Position.X));
    }

    [Fact]
    public async Task The_lock_is_listed_switched_and_kept_by_the_file()
    {
        await using var talk = await OpenAsync();
        await talk.TypeAsync("LAYER", "?", "");
        Assert.Matches(@"locked +plotted|plotted +locked", talk.Said);

        await talk.TypeAsync("SAVEAS", "kept.dxf");
        var path = talk.PathOf("kept.dxf");
        Assert.Equal([false, true], DxfReader.Read(await File.ReadAllBytesAsync(path), path, new DxfReadOptions(), CancellationToken.None).Layers.Select(layer => layer.Locked));
        await talk.TypeAsync("LAYER", "Unlock", "FIXED", "LOck", "0", "");
        Assert.Equal([true, false], talk.State.Drawing!.Layers.Select(layer => layer.Locked));
        await talk.TypeAsync("ERASE", "5,4", "");
        Assert.Equal(2, talk.State.Drawing!.Entities.Count);
    }

    private static async Task<CommandTestSession> OpenAsync()
    {
        var talk = new CommandTestSession();
        await File.WriteAllBytesAsync(talk.PathOf("in.dxf"), new DxfText().Header("AC1015", 4).Section("TABLES", s_layers).Section("ENTITIES", s_entities).End().ToAscii());
        await talk.TypeAsync("OPEN", "in.dxf");
        return talk;
    }

    /// <summary>Ends and layers of the locked objects.</summary>
    private static List<string> Locked(CommandTestSession talk)
    {
        var drawing = talk.State.Drawing!;
        return [.. from index in Enumerable.Range(0, drawing.Entities.Count)
            where drawing.SourceOf(index).Handle is "A2" or "A3"
            let line = drawing.Parts[drawing.Entities[index].FirstPart].InPlan()
            select $"{drawing.Layers[drawing.Entities[index].Layer].Name} {line.Start} {line.End}"];
    }
}
