using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Input;
using Engraver.App.Plots;
using Engraver.SoftwarePlatform.Bitmaps;
using Engraver.Workbench.Plots;

namespace Engraver.App.Tests.Plots;

[Collection(DesktopCollection.Name)]
public sealed class PlotTests(DesktopFixture fixture)
{
    private static readonly string? s_folder = Environment.GetEnvironmentVariable("ENGRAVER_PICTURES");

    [Fact]
    public Task The_position_of_the_playback_is_in_the_plot_and_a_click_in_it_seeks() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Window.Model.Playback.At = 10.0;
        var plot = ShowPlots(here);
        Assert.Equal(10.0, plot.Position, 6);
        here.Window.Model.Playback.At = 20.0;
        Assert.Equal(20.0, plot.Position, 6);

        here.Hands.Click(here.MiddleOf(plot));
        here.Step();

        var total = here.Window.Model.Playback.Total;
        Assert.InRange(here.Desk.Derived.AtSeconds / total, 0.4, 0.6);
        Assert.Equal(here.Desk.Derived.AtSeconds, plot.Position, 6);
        Assert.NotNull(here.Window.Canvas.Highlight);
    });

    [Fact]
    public Task The_wheel_zooms_a_drag_pans_and_fit_shows_everything() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        var plot = ShowPlots(here);
        var whole = plot.VisibleRange;
        Assert.Equal(0.0, whole.Start);
        Assert.Equal(here.Window.Model.Playback.Total, whole.End, 6);
        var middle = here.MiddleOf(plot);

        here.Hands.Wheel(middle, new Vector(0, 3));
        here.Step();
        var zoomed = plot.VisibleRange;
        Assert.True(plot.IsZoomed);
        Assert.InRange(zoomed.End - zoomed.Start, 0.05 * whole.End, 0.9 * whole.End);

        here.Hands.Drag(middle, middle + new Point(40, 0));
        here.Step();
        var panned = plot.VisibleRange;
        Assert.Equal(zoomed.End - zoomed.Start, panned.End - panned.Start, 6);
        Assert.True(panned.Start < zoomed.Start);
        Assert.Equal(0.0, here.Desk.Derived.AtSeconds); // a drag does not seek

        here.Click(here.Find<Button>("PlotFitButton"));
        Assert.Equal(whole, plot.VisibleRange);
    });

    [Fact]
    public Task Keys_zoom_and_pan_while_the_plot_has_the_focus_and_letters_go_to_the_command_line() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        var plot = ShowPlots(here);
        var whole = plot.VisibleRange;
        here.Hands.Click(here.MiddleOf(plot));
        here.Hands.Press(Key.Up);
        here.Step();
        var zoomed = plot.VisibleRange;
        Assert.InRange(zoomed.End - zoomed.Start, 0.6 * whole.End, 0.8 * whole.End);
        here.Hands.Press(Key.Right);
        here.Step();
        Assert.True(plot.VisibleRange.Start > zoomed.Start);
        here.Hands.Press(Key.Home);
        here.Step();
        Assert.Equal(whole, plot.VisibleRange);

        here.Hands.Type("Z");
        here.Step();
        Assert.Equal("Z", here.Window.Model.Command.Line);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
    });

    [Fact]
    public Task The_spans_of_a_selected_entity_are_marked_and_values_name_the_entity_under_the_pointer() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        var plot = ShowPlots(here);
        Assert.Empty(plot.Marks);
        var motion = here.Commands.Derivation.Current.Motion!;
        var entity = motion.At(motion.TimeOfStroke(0)!.Value + 0.5).Entity;

        here.Commands.Document.SelectIn(here.Commands.Document.Current.Drawing!, _ => [entity]);
        here.WaitUntilIdle();

        Assert.Equal(motion.TimesOf([entity]), plot.Marks);
        var (start, end) = Assert.Single(plot.Marks);
        Assert.Equal(motion.TimeOfEntity(entity), start);
        Assert.Equal(entity, motion.At(end - 1e-6).Entity);
        plot.Pointed = (start + end) / 2.0;
        var handle = here.Commands.Document.Current.Drawing!.SourceOf(entity).Handle;
        Assert.Contains($" {handle}   Speed ", here.Find<TextBlock>("PlotValues").Text!, StringComparison.Ordinal);
    });

    [Fact]
    public Task A_run_is_plotted_over_its_plan_and_another_run_for_comparison() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        var model = (PlotsModel)ShowPlots(here).DataContext!;
        Assert.Equal(["Speed", "Acceleration"], model.Content.Panels.Select(panel => panel.Key));
        here.Enter("CNCCONNECT", "sim:?speed=max", "CNCARM", "Stream", "CNCRUN");
        here.Until(() => here.Commands.Machine.Runs.LastRun is not null);
        here.WaitUntilIdle();
        here.Enter("CNCPLOTS", "63");

        Assert.Equal(["Speed", "Acceleration", "FollowingError", "Deviation", "FeedOverride", "LinkLoad"], model.Content.Panels.Select(panel => panel.Key));
        var run = Assert.Single(model.Content.Series, series => series.Role == PlotRole.Run).Motion;
        Assert.Equal(model.Content.Plan!.Path[^1], run.Path[^1], 0.5);
        Assert.All(run.Of(PlotQuantity.FeedOverride)!, value => Assert.True(double.IsNaN(value) || value == 100.0));
        var feed = here.Commands.Document.Current.Settings.Machine.FeedMmPerMinute;
        Assert.Contains(run.Of(PlotQuantity.Speed)!, speed => Math.Abs(speed - feed) < 0.02 * feed);

        Assert.Equal(2, model.Runs.Count);
        model.Compared = model.Runs[1];
        here.WaitUntilIdle();
        Assert.Equal([PlotRole.Plan, PlotRole.Run, PlotRole.Compared], model.Content.Series.Select(series => series.Role));
        Assert.Equal(model.Runs[1], model.Compared);
        model.Compared = StoredRunChoice.None;
        here.WaitUntilIdle();
        Assert.DoesNotContain(model.Content.Series, series => series.Role == PlotRole.Compared);
        Take(here, "plots-run");
    });

    [Fact]
    public Task Plots_over_the_path_seek_to_the_time_of_the_place() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        var plot = ShowPlots(here);
        here.Click(here.Find<ToggleButton>("PlotPathButton"));
        var plan = plot.Content.Plan!;
        Assert.Equal(PlotAxis.Path, plot.Content.Axis);
        Assert.Equal(plan.Path[^1], plot.VisibleRange.End, 6);

        ((PlotsModel)plot.DataContext!).Seek(plan.Path[^1] / 3.0);

        Assert.Equal(plan.Convert(PlotAxis.Path, plan.Path[^1] / 3.0, PlotAxis.Time), here.Desk.Derived.AtSeconds, 9);
        Assert.Equal(plan.Path[^1] / 3.0, plot.Position, 6);
    });

    [Fact]
    public Task An_empty_page_takes_every_input_of_the_pointer() => fixture.WithOperator(here =>
    {
        var plot = ShowPlots(here);
        UseIt();
        here.Open("gasket.dxf");
        here.Enter("CNCPLOTS", "0");
        Assert.Empty(plot.Content.Panels);
        UseIt();
        here.Enter("CNCPLOTS", "3");
        UseIt();
        Assert.True(plot.IsZoomed);

        void UseIt()
        {
            var middle = here.MiddleOf(plot);
            here.Hands.MovePointer(middle);
            here.Hands.Click(middle);
            here.Hands.Click(middle, MouseButton.Right);
            here.Hands.Wheel(middle, new Vector(0, 2));
            here.Hands.Drag(middle, middle + new Point(30, 5), button: MouseButton.Middle);
            here.Hands.Press(Key.Left);
            here.Step();
        }
    });

    [Fact]
    public Task A_zoomed_range_stays_when_the_window_moves_to_a_finer_screen() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        var plot = ShowPlots(here);
        here.Hands.Wheel(here.MiddleOf(plot), new Vector(0, 3));
        here.Step();
        var zoomed = plot.VisibleRange;

        here.Hands.SetScale(2.0);
        here.Step();

        Assert.True(plot.IsZoomed);
        Assert.Equal(zoomed.Start, plot.VisibleRange.Start, 6);
        Assert.Equal(zoomed.End, plot.VisibleRange.End, 6);
        here.Hands.SetScale(1.0);
        here.Step();
    });

    [Fact]
    public Task A_plan_that_is_sampled_in_the_background_appears_also_after_the_page_was_hidden_meanwhile() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        var plot = ShowPlots(here);
        var model = (PlotsModel)plot.DataContext!;
        here.Show("Layers");
        model.MaxSegmentsAtOnce = 0;
        model.IsPageVisible = true;
        Assert.True(model.IsSampling);
        Assert.True(model.IsEmpty);
        Assert.False(model.HasNothing);
        model.IsPageVisible = false;
        Assert.False(model.IsSampling);
        model.IsPageVisible = true;

        here.Until(() => !model.IsSampling);

        Assert.Equal(here.Window.Model.Playback.Total, model.Content.End, 6);
        Assert.True(model.Sampled.IsCompletedSuccessfully);
    });

    [Fact]
    public Task Runs_of_another_drawing_are_not_plotted() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        var model = (PlotsModel)ShowPlots(here).DataContext!;
        here.Enter("CNCSIM", "PLOTCOMPARE", "LAst");
        Assert.Equal([PlotRole.Plan, PlotRole.Run, PlotRole.Compared], model.Content.Series.Select(series => series.Role));

        here.Open("gasket.dxf");

        Assert.Equal(PlotRole.Plan, Assert.Single(model.Content.Series).Role);
        Assert.Equal(StoredRunChoice.None, model.Compared);
        Assert.Null(here.Commands.Plots.ComparedJournal);
    });

    [Fact]
    public Task Plots_are_exported_as_pictures_and_as_values() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        var folder = here.Commands.RunJournalFolder!;
        var (png, svg, csv) = (Path.Combine(folder, "plots.png"), Path.Combine(folder, "plots.svg"), Path.Combine(folder, "plots.csv"));
        here.Commands.Settings.Change(settings => settings.WithVariable("FILEDIA", 0));

        here.Enter("PLOTEXPORT", png, "PLOTEXPORT", svg, "PLOTEXPORT", csv);

        using (var file = File.OpenRead(png))
        using (var picture = PngFile.Read(file))
        {
            Assert.Equal(new PixelSize(1600, 640), picture.PixelSize);
        }

        var drawn = File.ReadAllText(svg);
        Assert.Contains("<svg", drawn, StringComparison.Ordinal);
        Assert.Contains("Speed, mm/min", drawn, StringComparison.Ordinal);
        var lines = File.ReadAllLines(csv);
        Assert.Equal("motion,seconds,path_mm,entity,speed_mm_per_min,acceleration_x_mm_per_s2,acceleration_y_mm_per_s2", lines[0]);
        Assert.All(lines[1..], line => Assert.Equal(7, line.Split(',').Length));
        if (s_folder is not null) File.Copy(png, Path.Combine(s_folder, "plots-export.png"), overwrite: true);
    });

    [Theory]
    [InlineData("Dark", 1.0)]
    [InlineData("Light", 1.0)]
    [InlineData("HighContrast", 1.0)]
    [InlineData("Dark", 2.0)]
    public Task Plots_have_titles_and_curves_in_every_theme_and_at_every_scale(string theme, double scale) => fixture.WithOperator(here =>
    {
        here.Hands.SetScale(scale);
        here.Enter("THEME", theme);
        here.Open("gasket.dxf");
        var plot = ShowPlots(here);
        here.Click(here.Find<Button>("PlotEnlargeButton"));
        var place = plot.TranslatePoint(default, here.Window)!.Value;
        Assert.True(plot.Bounds.Width > 500);
        var (left, top) = ((int)(place.X * scale), (int)(place.Y * scale));
        var (width, height) = ((int)(plot.Bounds.Width * scale), (int)(plot.Bounds.Height * scale));
        var curve = Resource(here, "PlotPlanBrush");

        Assert.Contains(Enumerable.Range(0, height), y => Enumerable.Range(0, width).Count(x => here.Hands.PixelAt(left + x, top + y) == curve) > 50);
        Take(here, FormattableString.Invariant($"plots-{theme}-{scale * 100:0}"));
        here.Enter("THEME", "Dark");
        here.Hands.SetScale(1.0);
    });

    private static PlotSurface ShowPlots(Operator here)
    {
        here.Show("Plots");
        return here.Find<PlotSurface>("Plot");
    }

    private static Avalonia.Media.Color Resource(Operator here, string key) =>
        here.Window.TryFindResource(key, here.Window.ActualThemeVariant, out var found) && found is Avalonia.Media.ISolidColorBrush brush ? brush.Color : default;

    private static void Take(Operator here, string name)
    {
        if (s_folder is null) return;
        here.Step();
        using var file = File.Create(Path.Combine(s_folder, name + ".png"));
        here.Hands.CapturePng(file);
    }
}
