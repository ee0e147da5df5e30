using Avalonia.Controls;
using Avalonia.Media;
using Engraver.App.Canvas.Colours;
using Engraver.App.Operations;
using Engraver.App.Properties;
using Engraver.App.Texts;
using Engraver.Core.Operations;
using Engraver.TestKit;
using Engraver.Workbench.Views;

namespace Engraver.App.Tests.Operations;

[Collection(DesktopCollection.Name)]
public sealed class OperationsTests(DesktopFixture fixture)
{
    [Fact]
    public Task The_list_shows_what_each_operation_takes_and_edits_it_by_steps_that_undo() => fixture.WithOperator(here =>
    {
        WithPlate(here);
        Assert.Equal(Plan(here)!.Operations.Select(operation => operation.Title), Rows(here).Select(row => row.Title));
        Assert.All(Rows(here), row => Assert.NotEqual("0", row.Curves));
        var first = Rows(here)[0].Operation;

        here.Click(here.Find<Button>("DownButton"));
        here.WaitUntilIdle();
        Assert.Equal(1, Plan(here)!.Operations.ToList().FindIndex(one => one.Id == first.Id));
        here.Click(here.Find<CheckBox>("OnBox"));
        here.WaitUntilIdle();
        Assert.False(Plan(here)!.Operations[0].IsOn);
        here.Click(here.Find<Button>("DeleteOperationButton"));
        here.WaitUntilIdle();
        Assert.Equal(first.Id, Plan(here)!.Operations[0].Id);
        for (var step = 0; step < 3; step++) Run(here, "U");
        Assert.Equal((first.Id, true), (Plan(here)!.Operations[0].Id, Plan(here)!.Operations.All(one => one.IsOn)));
    });

    [Fact]
    public Task A_field_that_is_typed_changes_the_selected_operation_and_a_wrong_one_is_refused() => fixture.WithOperator(here =>
    {
        WithPlate(here);
        var (list, fields) = (here.Find<ListBox>("OperationList"), here.Find<PropertyLinesView>("FieldLines"));
        list.SelectedIndex = Rows(here).ToList().FindIndex(row => row.Operation.Kind == OperationKind.Profile);
        here.Step();
        var profile = Rows(here)[list.SelectedIndex].Operation;
        Assert.Equal("{\"count\":4,\"width\":3,\"height\":1}", fields.Lines!.Single(line => line.Name == "Tabs").Value);

        Accept(here, fields, "Depth, mm", "2.5");
        Assert.Equal(2.5, Find(here, profile).Depth);
        Accept(here, fields, "Tabs", "");
        Assert.Null(Find(here, profile).Tabs);
        Accept(here, fields, "Feed, mm/min", "-1");
        Assert.Equal((profile.Feed, 2.5), (Find(here, profile).Feed, Find(here, profile).Depth));
        Assert.Contains(here.History, line => line.Contains("feed", StringComparison.Ordinal));
    });

    [Fact]
    public Task The_canvas_shows_the_path_of_each_operation_in_the_colour_of_its_row_until_it_is_switched_off() => fixture.WithOperator(here =>
    {
        here.Open("operation-plate.dxf");
        Assert.False(here.Window.Canvas.Overlay!.HasOperations);
        WithPlate(here);
        here.Until(() => here.Window.Canvas.Overlay!.HasOperations);
        var overlay = here.Window.Canvas.Overlay!;

        Assert.Equal(overlay.MoveCount, overlay.Operations.Count);
        Assert.Equal(Enumerable.Range(0, Rows(here).Count), overlay.Operations.Primitives.Select(move => (int)move.Colour).Distinct().Order());
        Assert.Equal(CanvasTheme.Dark.Operations.Take(Rows(here).Count), Rows(here).Select(row => ((ISolidColorBrush)row.Colour).Color.ToUInt32()));
        Run(here, "SHOW", "OP", "OFF");
        Assert.False(here.Commands.View.Current.Shown.HasFlag(CanvasLayers.Operations));
    });

    [Fact]
    public void Every_field_of_an_operation_has_a_name()
    {
        foreach (var field in Enum.GetValues<OperationKind>().SelectMany(OperationFile.FieldsOf).Distinct().Where(field => field != "id")) Assert.NotEqual("OperationField." + field, Text.Get("OperationField." + field));
    }

    private static void WithPlate(Operator here)
    {
        here.Open("operation-plate.dxf");
        Run(here, "CNCPROFILE", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"));
        Run(here, "CNCCUT", "32");
        Run(here, "OPERATION", "LOad", Path.Combine(RepositoryFolder.Samples, "operation-plate.operations.json"));
        here.Show("Operations");
    }

    private static void Accept(Operator here, PropertyLinesView fields, string name, string text)
    {
        var line = fields.Lines!.Single(one => one.Name == name);
        line.Typed = text;
        line.Accept();
        here.WaitUntilIdle();
    }

    private static void Run(Operator here, params string[] inputs)
    {
        _ = here.Desk.Queue.RunAsync(inputs);
        here.WaitUntilIdle();
    }

    private static Operation Find(Operator here, Operation operation) => Plan(here)!.Operations.Single(one => one.Id == operation.Id);

    private static OperationPlan? Plan(Operator here) => here.Commands.Document.Current.Settings.Operations;

    private static IReadOnlyList<OperationRow> Rows(Operator here) => [.. here.Find<ListBox>("OperationList").Items.Cast<OperationRow>()];
}
