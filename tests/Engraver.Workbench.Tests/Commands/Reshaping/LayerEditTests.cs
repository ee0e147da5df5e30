using Engraver.TestKit;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Reshaping;

/// <summary>LAYER makes, renames and sets.</summary>
public class LayerEditTests
{
    [Fact]
    public async Task A_layer_is_made_and_becomes_current_in_one_step()
    {
        await using var talk = Shape.Talk(new DrawingBuilder().Line(0, 0, 10, 0));
        var steps = talk.Session.Document.UndoNames.Count();
        await talk.TypeAsync("LA", "Make", "Deep cut", "C", "red", "deep cut", "");

        Assert.Equal(["0", "Deep cut"], talk.State.Drawing!.Layers.Select(layer => layer.Name));
        Assert.Equal(("Deep cut", 1), (talk.State.CurrentLayer, talk.State.Drawing.Layers[1].Colour.Index));
        Assert.Equal(steps + 1, talk.Session.Document.UndoNames.Count());
        await talk.TypeAsync("U");
        Assert.Equal(("0", 1), (talk.State.CurrentLayer, talk.State.Drawing!.Layers.Count));
    }

    [Fact]
    public async Task Renaming_follows_the_current_layer_and_the_settings_that_name_it()
    {
        await using var talk = Shape.Talk(new DrawingBuilder().Line(0, 0, 10, 0));
        await talk.TypeAsync("LAYER", "M", "A", "");
        talk.Session.Document.Take("X", talk.State with { Settings = talk.State.Settings with { SkippedLayers = ["a"] } });
        await talk.TypeAsync("LAYER", "R", "a", "B", "");

        Assert.Equal(["0", "B"], talk.State.Drawing!.Layers.Select(layer => layer.Name));
        Assert.Equal(("B", "B"), (talk.State.CurrentLayer, Assert.Single(talk.State.Settings.SkippedLayers)));
        await talk.TypeAsync("LAYER", "S", "0", "?", "");
        Assert.Equal("0", talk.State.CurrentLayer);
        Assert.Contains("Current layer: 0.", talk.Said, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("M", "a|b", "cannot be the name")]
    [InlineData("S", "nowhere", "no layer 'nowhere'")]
    [InlineData("R", "0", "cannot be renamed", "X")]
    [InlineData("R", "A", "already", "0")]
    [InlineData("S", "COLD", "frozen")]
    public async Task What_cannot_be_is_told(string option, string name, string told, string? second = null)
    {
        await using var talk = Shape.Talk(new DrawingBuilder().Line(0, 0, 10, 0));
        await talk.TypeAsync("LAYER", "M", "A", "M", "COLD", "S", "A", "F", "COLD", "");
        var before = talk.State;
        var result = await talk.TypeAsync(second is null ? ["LAYER", option, name] : ["LAYER", option, name, second]);

        Assert.Contains(told, Assert.IsType<InputResult.Failed>(result).Sentence, StringComparison.Ordinal);
        Assert.Same(before, talk.State);
    }
}
