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
        here.Rest();
        Assert.False(Layer(here, "VENTS").On);
        Assert.Contains("Command: LAYER", here.History);
        Assert.False(SwitchesOf(here, "VENTS")[0].IsChecked);

        here.Enter("U");

        Assert.True(Layer(here, "VENTS").On);
        Assert.True(SwitchesOf(here, "VENTS")[0].IsChecked);
    });

    [Fact]
    public Task Frozen_and_not_plotted_are_switched_apart() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Click(SwitchesOf(here, "MARKS")[1]);
        here.Rest();
        here.Click(SwitchesOf(here, "INSIDE")[2]);
        here.Rest();

        Assert.True(Layer(here, "MARKS").Frozen);
        Assert.True(Layer(here, "MARKS").Plot);
        Assert.False(Layer(here, "INSIDE").Plot);
        Assert.False(Layer(here, "INSIDE").Frozen);
    });

    private static Core.Drawings.Layer Layer(Operator here, string name) => here.Commands.Document.Current.Drawing!.Layers.Single(layer => layer.Name == name);

    private static List<CheckBox> SwitchesOf(Operator here, string name) =>
        [.. here.Find<ListBox>("LayerList").GetVisualDescendants().OfType<CheckBox>().Where(box => box.DataContext is LayerRow row && row.Name == name)];
}
