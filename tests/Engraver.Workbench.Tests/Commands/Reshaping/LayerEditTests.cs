using Engraver.Core.Drawings;
using Engraver.TestKit;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Reshaping;

/// <summary>LAYER creates, renames and sets layers.</summary>
public class LayerEditTests
{
    [Fact]
    public async Task A_layer_is_made_and_becomes_current_in_one_step()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0));
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
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0));
        await talk.TypeAsync("LAYER", "M", "A", "");
        talk.Session.Document.Commit("X", talk.State with { Settings = talk.State.Settings with { SkippedLayers = ["a"] } });
        await talk.TypeAsync("LAYER", "R", "a", "B", "");

        Assert.Equal(["0", "B"], talk.State.Drawing!.Layers.Select(layer => layer.Name));
        Assert.Equal(("B", "B"), (talk.State.CurrentLayer, Assert.Single(talk.State.Settings.SkippedLayers)));
        await talk.TypeAsync("LAYER", "S", "0", "?", "");
        Assert.Equal("0", talk.State.CurrentLayer);
        Assert.Contains("Current layer: 0.", talk.Said, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("M", "a|b", "is not a valid layer name", "B")]
    [InlineData("S", "nowhere", "no layer 'nowhere'", "0")]
    [InlineData("S", "COLD", "frozen", "0")]
    [InlineData("R", "0", "cannot be renamed", "COLD", "WARM")]
    [InlineData("R COLD", "0", "already", "WARM")]
    [InlineData("C", "mauve", "is not a colour", "red", "0")]
    [InlineData("F", "A,nowhere,never", "no layer 'nowhere', 'never'", "*")]
    public async Task What_cannot_be_is_told_and_asked_once_more_so_that_nothing_typed_before_is_lost(string option, string name, string told, params string[] then)
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0));
        await talk.TypeAsync("LAYER", "M", "A", "M", "COLD", "S", "A", "F", "COLD", "");
        var before = talk.State;
        await talk.TypeAsync(["LAYER", "OFF", "A", .. option.Split(' ')]);
        var question = talk.Session.Prompt.Text;

        Assert.Contains(told, Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync(name)).Message, StringComparison.Ordinal);
        Assert.Equal((question, before), (talk.Session.Prompt.Text, talk.State));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync([.. then, ""]));
        Assert.False(talk.State.Drawing!.Layers.Single(layer => layer.Name == "A").On);
    }

    [Fact]
    public async Task Where_layer_0_is_the_only_one_nothing_is_renamed_and_nothing_lost()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0));
        await talk.TypeAsync("LAYER", "C", "red", "0", "R");
        Assert.Contains("cannot be renamed", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(""));
        Assert.Equal(1, Assert.Single(talk.State.Drawing!.Layers).Colour.Index);
        await talk.TypeAsync("LAYER", "M", "A", "S", "0", "R");
        Assert.Equal("Enter old layer name:", talk.Session.Prompt.Text);
    }

    [Fact]
    public async Task A_layer_whose_name_has_a_comma_is_switched_by_its_whole_name()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().OnLayer(new Layer("1,5 mm", true, false, true)).Line(0, 0, 10, 0));
        await talk.TypeAsync("LAYER", "OFF", "1,5 mm", "");
        Assert.False(talk.State.Drawing!.Layers.Single(layer => layer.Name == "1,5 mm").On);
    }

    [Fact]
    public async Task In_a_script_what_cannot_be_ends_the_script_with_its_place()
    {
        await using var talk = ObjectText.Talk(new DrawingBuilder().Line(0, 0, 10, 0));
        var script = talk.PathOf("layers.scr");
        await File.WriteAllTextAsync(script, "LAYER\nColor\nmauve\n0\n\nLAYER\nMake\nLATER\n\n");

        var sentence = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SCRIPT", script)).Message;
        Assert.Contains("layers.scr(3)", sentence, StringComparison.Ordinal);
        Assert.Equal(["0"], talk.State.Drawing!.Layers.Select(layer => layer.Name));
    }
}
