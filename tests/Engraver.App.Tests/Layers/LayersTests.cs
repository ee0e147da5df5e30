using Avalonia.Controls;
using Avalonia.VisualTree;
using Engraver.App.Layers;

namespace Engraver.App.Tests.Layers;

[Collection(DesktopCollection.Name)]
public sealed class LayersTests(DesktopFixture fixture)
{
    [Fact]
    public Task A_switch_runs_the_command_and_undo_takes_it_back() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Click(SwitchesOf(here, "VENTS")[0]);
        here.WaitUntilIdle();
        Assert.False(Layer(here, "VENTS").On);
        Assert.Contains("Command: LAYER", here.History);
        Assert.False(SwitchesOf(here, "VENTS")[0].IsChecked);

        here.Enter("U");

        Assert.True(Layer(here, "VENTS").On);
        Assert.True(SwitchesOf(here, "VENTS")[0].IsChecked);
    });

    [Fact]
    public Task The_curves_of_a_layer_are_counted_anew_when_some_are_erased() => fixture.WithOperator(here =>
    {
        Assert.True(here.Find<TextBlock>("NoLayersText").IsEffectivelyVisible);
        here.Open("gasket.dxf");
        Assert.False(here.Find<TextBlock>("NoLayersText").IsEffectivelyVisible);
        Assert.Equal(30, CurvesOf("VENTS"));
        here.Enter("ERASE", "LA", "VENTS", "");
        Assert.Equal(0, CurvesOf("VENTS"));
        here.Enter("U");
        Assert.Equal(30, CurvesOf("VENTS"));

        int CurvesOf(string layer) => here.Find<ListBox>("LayerList").Items.Cast<LayerRow>().Single(row => row.Name == layer).Curves;
    });

    [Fact]
    public Task Frozen_and_not_plotted_are_switched_apart() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Click(SwitchesOf(here, "MARKS")[1]);
        here.WaitUntilIdle();
        here.Click(SwitchesOf(here, "INSIDE")[2]);
        here.WaitUntilIdle();

        Assert.True(Layer(here, "MARKS").Frozen);
        Assert.True(Layer(here, "MARKS").Plot);
        Assert.False(Layer(here, "INSIDE").Plot);
        Assert.False(Layer(here, "INSIDE").Frozen);
    });

    [Fact]
    public Task The_swatch_offers_nine_colours_and_the_canvas_follows() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        var swatch = here.Find<ListBox>("LayerList").GetVisualDescendants().OfType<Button>().First(button => button is { Name: "Swatch", DataContext: LayerRow { Name: "VENTS" } });
        var row = (LayerRow)swatch.DataContext!;
        Assert.Equal(["red", "yellow", "green", "cyan", "blue", "magenta", "white", "8", "9"], row.Choices.Select(choice => choice.Name));

        here.Click(swatch);
        Assert.True(swatch.Flyout!.IsOpen);
        swatch.Flyout.Hide();
        row.Choices[5].Choose.Execute(null);
        here.WaitUntilIdle();

        Assert.Equal(6, Layer(here, "VENTS").Colour.Index);
        var scene = here.Window.Canvas.Scene!;
        var vent = Enumerable.Range(0, scene.Drawing.Entities.Count).First(entity => scene.Drawing.Layers[scene.Drawing.Entities[entity].Layer].Name == "VENTS");
        Assert.Equal(6, scene.Colours[vent]);
        here.Enter("U");
        Assert.NotEqual(6, Layer(here, "VENTS").Colour.Index);
    });

    private static Core.Drawings.Layer Layer(Operator here, string name) => here.Commands.Document.Current.Drawing!.Layers.Single(layer => layer.Name == name);

    private static List<CheckBox> SwitchesOf(Operator here, string name) =>
        [.. here.Find<ListBox>("LayerList").GetVisualDescendants().OfType<CheckBox>().Where(box => box.DataContext is LayerRow row && row.Name == name)];
}
