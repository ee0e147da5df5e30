using Avalonia.Controls;
using Avalonia.Input;
using Engraver.App.Trajectories;
using Engraver.Workbench.Sidecars;
using Engraver.Workbench.Views;

namespace Engraver.App.Tests.Trajectories;

[Collection(DesktopCollection.Name)]
public sealed class TrajectoriesTests(DesktopFixture fixture)
{
    [Fact]
    public Task The_table_lists_trajectories_and_what_is_typed_into_it_is_a_step_that_undoes() => fixture.WithOperator(here =>
    {
        WithTwo(here);
        var rows = Rows(here);

        Assert.Equal(["traj0_path", "traj1_path"], rows.Select(row => row.Name));
        Assert.Equal(All(here).Select(one => (one.Curve.Points.ToString(System.Globalization.CultureInfo.InvariantCulture), one.Curve.VerifiedBound <= 0.001)), rows.Select(row => (row.Points, !row.ExceedsTolerance)));
        Type(here, "NameBox", "ring");
        Assert.Equal("ring", All(here)[0].Name);
        Type(here, "ZBox", "-0.25");
        Assert.Equal(-0.25, All(here)[0].Curve.Z);
        Type(here, "ErrorBox", "0.02");
        Assert.InRange(All(here)[0].Curve.VerifiedBound, 0.001, 0.02);
        here.Click(here.Find<Button>("DeleteOneButton"));
        here.WaitUntilIdle();
        Assert.Equal(["traj1_path"], Rows(here).Select(row => row.Name));
        for (var step = 0; step < 4; step++) Run(here, "U");
        Assert.Equal(("traj0_path", 0.0), (Rows(here)[0].Name, All(here)[0].Curve.Z));
    });

    [Fact]
    public Task A_name_that_is_refused_does_not_stay_in_the_field() => fixture.WithOperator(here =>
    {
        WithTwo(here);
        Type(here, "NameBox", "traj1_path");

        Assert.Equal("traj0_path", here.Find<TextBox>("NameBox").Text);
        Assert.Contains(here.History, line => line.Contains("Trajectory traj1_path already exists", StringComparison.Ordinal));
    });

    [Fact]
    public Task The_canvas_shows_curves_and_points_until_they_are_switched_off_or_undone() => fixture.WithOperator(here =>
    {
        WithTwo(here);
        var (curves, marks) = (here.Window.Canvas.Overlay!.Trajectories.Count, here.Window.Canvas.Overlay!.TrajectoryMarks.Count);

        Assert.Equal((8 * All(here).Sum(one => one.Curve.Points - 1), All(here).Sum(one => one.Curve.Points)), (curves, marks));
        Run(here, "SHOW", "T", "OFF");
        Assert.False(here.Commands.View.Current.Shown.HasFlag(CanvasLayers.Trajectories));
        Run(here, "U");
        Run(here, "U");
        Assert.Equal(0, here.Window.Canvas.Overlay!.Trajectories.Count);
    });

    [Fact]
    public Task Trajectories_whose_objects_were_edited_are_marked_until_they_are_made_anew() => fixture.WithOperator(here =>
    {
        WithTwo(here);
        Assert.Equal([false, false], Rows(here).Select(row => row.IsStale));
        Assert.False(here.Find<Button>("UpdateTrajectoriesButton").IsVisible);
        Run(here, "MOVE", "H", All(here)[1].Handles[0], "", "0,0", "0.1,0");
        Assert.Equal([false, true], Rows(here).Select(row => row.IsStale));
        here.Step();
        here.Click(here.Find<Button>("UpdateTrajectoriesButton"));
        here.WaitUntilIdle();

        Assert.Equal([false, false], Rows(here).Select(row => row.IsStale));
        Assert.Equal(["traj0_path", "traj1_path"], Rows(here).Select(row => row.Name));
    });

    private static void WithTwo(Operator here)
    {
        here.Open("gasket.dxf");
        var circles = Enumerable.Range(0, here.Commands.Document.Current.Drawing!.Entities.Count).Where(entity => here.Commands.Document.Current.Drawing!.Entities[entity].Type == Engraver.Core.Drawings.CurveType.Circle).Take(2).ToList();
        foreach (var circle in circles) Run(here, "SACEPATH", "H", here.Commands.Document.Current.Drawing!.SourceOf(circle).Handle!, "");
        here.Show("Trajectories");
    }

    /// <summary>As from a menu, because a page other than the command window is in front.</summary>
    private static void Run(Operator here, params string[] inputs)
    {
        _ = here.Desk.Queue.RunAsync(inputs);
        here.WaitUntilIdle();
    }

    private static IReadOnlyList<DocumentTrajectory> All(Operator here) => here.Commands.Document.Current.Sidecar.Trajectories.All;

    private static IReadOnlyList<TrajectoryRow> Rows(Operator here) => [.. here.Find<ListBox>("TrajectoryList").Items.Cast<TrajectoryRow>()];

    /// <summary>Types into a field of the first row, with Enter.</summary>
    private static void Type(Operator here, string box, string text)
    {
        var field = here.Find<TextBox>(box);
        here.Click(field);
        field.SelectAll();
        here.Hands.Type(text);
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();
    }
}
