using Engraver.Core.Drawings;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands.Drafting;

public class CurrentLayerTests
{
    [Fact]
    public async Task Clayer_names_a_layer_of_the_drawing_in_any_case_and_undo_brings_the_former_one_back()
    {
        await using var talk = WithLayers();
        await talk.TypeAsync("CLAYER", "marks");
        Assert.Equal("Marks", talk.State.CurrentLayer);
        await talk.TypeAsync("CLAYER");
        Assert.Equal("Enter new value for CLAYER <Marks>:", talk.Session.Prompt.Text);
        await talk.TypeAsync("", "U");

        Assert.Equal("0", talk.State.CurrentLayer);
    }

    [Fact]
    public async Task A_layer_that_is_not_there_or_is_frozen_is_refused()
    {
        await using var talk = WithLayers();

        Assert.Contains("no layer 'nowhere'", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CLAYER", "nowhere")).Message, StringComparison.Ordinal);
        Assert.Contains("'Cold' is frozen", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CLAYER", "COLD")).Message, StringComparison.Ordinal);
        Assert.Equal("0", talk.State.CurrentLayer);
    }

    private static CommandTestSession WithLayers()
    {
        var talk = CommandTestSession.WithDrawing();
        var drawing = talk.State.Drawing!;
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = drawing with { Layers = [.. drawing.Layers, new Layer("Marks", true, false, true), new Layer("Cold", true, true, true)] } });
        return talk;
    }
}
