using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.Properties;
using Engraver.Core.Drawings;
using Engraver.TestKit;
using Engraver.Workbench.Documents;

namespace Engraver.App.Tests.Properties;

/// <summary>The palette for a circle (A1, radius 20), another one (A2, radius 10) and a line (A3) on two layers, with mouse and keys.</summary>
[Collection(DesktopCollection.Name)]
public sealed class PropertiesPaletteTests(DesktopFixture fixture)
{
    [Fact]
    public Task The_palette_shows_what_is_selected_in_sections_and_varies() => With(here =>
    {
        Select(here, 0);
        Assert.Equal("20", Line(here, "Radius").Value);
        Assert.Equal(["General", "Geometry", "Entity table, 16 slots"], Lines(here).Where(line => line.IsHeader).Select(line => line.Name).Take(3));
        Select(here, 0, 1);
        Assert.Equal("*VARIES*", Line(here, "Radius").Value);
        Assert.Equal("CIRCLE", Line(here, "Type").Value);
        Select(here, 0, 2);
        Assert.DoesNotContain(Lines(here), line => line.Name == "Radius");
        Select(here);
        Assert.Empty(Lines(here));
    });

    [Fact]
    public Task A_radius_is_typed_in_its_field_and_undone_in_one_step() => With(here =>
    {
        Select(here, 0, 1);
        Type(here, "Radius", "12.5", Key.Enter);
        Assert.Equal([12.5, 12.5], new[] { Radius(here, 0), Radius(here, 1) });
        Assert.Equal("12.5", Line(here, "Radius").Value);
        Assert.Equal([0, 1], here.Commands.Document.Current.Selection);
        here.Enter("U");
        Assert.Equal([20.0, 10.0], new[] { Radius(here, 0), Radius(here, 1) });
    });

    [Fact]
    public Task A_wrong_value_is_told_once_and_the_field_shows_the_old_one() => With(here =>
    {
        Select(here, 0);
        Type(here, "Radius", "-3", Key.Enter);
        Assert.Equal((20.0, "20"), (Radius(here, 0), Line(here, "Radius").Typed));
        Assert.Equal(1, here.History.Count(line => line.Contains("Radius cannot be -3", StringComparison.Ordinal)));
        Assert.Equal([0], here.Commands.Document.Current.Selection);
    });

    [Fact]
    public Task While_a_command_asks_nothing_is_changed_and_it_is_said() => With(here =>
    {
        Select(here, 0);
        _ = here.Desk.Queue.RunAsync("DIST");
        here.WaitUntilIdle();
        Type(here, "Radius", "7", Key.Enter);

        Assert.Equal(20.0, Radius(here, 0));
        Assert.Contains(here.History, line => line.StartsWith("Radius was not changed because DIST is waiting for input.", StringComparison.Ordinal));
    });

    [Fact]
    public Task Esc_gives_a_field_up_and_keeps_the_selection() => With(here =>
    {
        Select(here, 0);
        Type(here, "Radius", "7", Key.Escape);
        Assert.Equal((20.0, "20"), (Radius(here, 0), Line(here, "Radius").Typed));
        Assert.Equal([0], here.Commands.Document.Current.Selection);
    });

    [Fact]
    public Task A_layer_is_chosen_and_a_colour_typed() => With(here =>
    {
        Select(here, 0, 2);
        var box = Field<ComboBox>(here, "Layer");
        Assert.Equal(["0", "CUT"], box.Items.Cast<string>());
        box.SelectedItem = "CUT";
        here.WaitUntilIdle();
        Type(here, "Color", "red", Key.Enter);
        var entities = here.Commands.Document.Current.Drawing!.Entities;
        Assert.Equal([(1, 1), (0, null), (1, (int?)1)], new[] { 0, 1, 2 }.Select(index => (entities[index].Layer, entities[index].Colour.Index)));
        here.Enter("U", "U");
        Assert.Equal(0, here.Commands.Document.Current.Drawing!.Entities[0].Layer);
    });

    /// <summary>The text of a field belongs to the selection at the time of typing.</summary>
    [Fact]
    public Task Leaving_a_field_takes_it_for_the_object_that_was_shown() => With(here =>
    {
        Select(here, 0);
        var line = Line(here, "Radius");
        line.Typed = "33";
        Select(here, 1);
        line.Accept();
        here.WaitUntilIdle();
        Assert.Equal((20.0, 10.0), (Radius(here, 0), Radius(here, 1)));
    });

    [Fact]
    public Task A_list_has_its_keys_to_itself() => With(here =>
    {
        here.Enter("ERASE", "H", "A2", "");
        var entities = here.Commands.Document.Current.Drawing!.Entities.Count;
        Select(here, 0);
        var list = here.Find<ListBox>("LineList").GetVisualDescendants().OfType<ComboBox>().First(box => box is { IsEffectivelyVisible: true, DataContext: PropertyLine { Name: "Layer" } });
        list.Focus();
        list.IsDropDownOpen = true;
        here.Step();
        here.Hands.Press(Key.Down);
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();

        Assert.Equal(entities, here.Commands.Document.Current.Drawing!.Entities.Count); // ERASE was not repeated
        Assert.Equal([0], here.Commands.Document.Current.Selection);
    });

    private Task With(Action<Operator> test) => fixture.WithOperator(here =>
    {
        var cut = new Layer("CUT", On: true, Frozen: false, Plot: true);
        var drawing = new DrawingBuilder().Circle(0, 0, 20).Circle(100, 0, 10).OnLayer(cut).Line(0, 50, 100, 50).Build();
        here.Commands.Document.Commit("OPEN", new DocumentState { Drawing = drawing });
        here.WaitUntilIdle();
        here.Show("Properties");
        test(here);
    });

    private static void Select(Operator here, params int[] objects)
    {
        here.Commands.Document.Select(objects, []);
        here.WaitUntilIdle();
    }

    private static IEnumerable<PropertyLine> Lines(Operator here) => here.Find<ListBox>("LineList").Items.Cast<PropertyLine>();

    private static PropertyLine Line(Operator here, string name) => Lines(here).First(line => line.Name == name);

    private static T Field<T>(Operator here, string name)
        where T : Control
    {
        var list = here.Find<ListBox>("LineList");
        list.ScrollIntoView(Line(here, name));
        here.Step();
        return list.GetVisualDescendants().OfType<T>().First(field => field.DataContext is PropertyLine line && line.Name == name && field.IsEffectivelyVisible);
    }

    private static void Type(Operator here, string name, string text, Key end)
    {
        here.Click(Field<TextBox>(here, name));
        here.Hands.Press(Key.A, RawInputModifiers.Control);
        here.Hands.Type(text);
        here.Hands.Press(end);
        here.WaitUntilIdle();
    }

    private static double Radius(Operator here, int entity) => DrawingPick.Segments(here.Commands.Document.Current.Drawing!, entity).Single().Arc.Radius;
}
