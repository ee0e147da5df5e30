using Avalonia;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.Simulator;
using Engraver.SoftwarePlatform.Bitmaps;
using Engraver.TestKit;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Canvas.Rasterising;

/// <summary>Pictures of the real program in the states that an operator sees. With ENGRAVER_PICTURES they are stored in that folder for review.</summary>
[Collection(DesktopCollection.Name)]
public sealed class PictureTests(DesktopFixture fixture)
{
    /// <summary>Limits the size of a manual with many pictures.</summary>
    private const int MostBytes = 150_000;

    private static readonly Size s_usual = new(1280, 800);
    private static readonly string? s_folder = Environment.GetEnvironmentVariable("ENGRAVER_PICTURES");

    [Fact]
    public Task A_drawing_is_open() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "nameplate.dxf");
        here.Show("Layers");
        here.Show("Command");
        Take(here, "drawing");
        here.Show("Contours");
        here.Enter("SHOW", "All");
        Take(here, "order-and-rapids");
        here.Show("Table");
        here.Show("Properties");
        here.Window.Model.Playback.At = here.Window.Model.Playback.Total / 3;
        here.Step();
        Take(here, "entity-table");
        here.Show("Command");
        here.Enter("SHOW", "None");
    });

    [Fact]
    public Task The_doctor_has_findings() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "gasket.dxf");
        here.Enter("CHECK");
        here.Show("Findings");
        Take(here, "findings");
    });

    [Fact]
    public Task The_link_is_lost() => fixture.WithOperator(here =>
    {
        var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var listening = controller.ListenTcpAsync(0, CancellationToken.None);
        here.Until(() => listening.IsCompleted);
        here.Hands.Resize(s_usual);
        Open(here, "gasket.dxf");
        here.Enter("CNCCONNECT", FormattableString.Invariant($"tcp://127.0.0.1:{listening.Result.Port}"));
        var ending = controller.DisposeAsync().AsTask();
        here.Until(() => here.Commands.Machine.Alarms.Open.Count > 0 && ending.IsCompleted);
        here.Show("Alarms");
        Take(here, "alarm");
    });

    [Fact]
    public Task The_playback_stands_in_the_middle() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "gasket.dxf");
        here.Show("Program");
        here.Show("Table");
        here.Window.Model.Playback.At = here.Window.Model.Playback.Total / 2;
        here.Step();
        Take(here, "playback");
        here.Show("Plots");
        Take(here, "speed-plot");
    });

    [Fact]
    public Task A_small_window_loses_nothing() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(new Size(1024, 700));
        Open(here, "gasket.dxf");
        here.Enter("CNCCONNECT", "sim:");
        here.Hands.Type("Z");
        here.Step();
        Take(here, "small");
        here.Hands.Press(Key.Escape);
        here.Rest();
        here.Enter("MOVE");
        Take(here, "small-options");
    });

    [Fact]
    public Task A_machine_with_a_z_axis_is_commissioned() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        here.Enter("CNCPROFILE", "machine-mill.json", "CNCCONNECT", "sim:", "CNCMOTORS", "ON", "CNCJOG", "12,-4", "CNCJOG", "Z+", "11.5", "CNCZERO", "All", "CNCJOG", "Z-", "2.25");
        here.Show("Machine");
        Take(here, "machine-page");
        here.Show("Commissioning");
        here.Enter("CNCCOMMISSION", "Skip", "Skip");
        Take(here, "commissioning");
        here.Hands.Press(Key.Escape);
        here.Rest();
    });

    [Fact]
    public Task The_simulated_machine_is_armed() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "nameplate.dxf");
        here.Enter("CNCCONNECT", "sim:");
        here.Show("Job");
        here.Enter("CNCARM", "Stream");
        Take(here, "armed");
    });

    [Fact]
    public Task A_job_runs_on_the_simulated_controller() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "nameplate.dxf");
        here.Enter("CNCCONNECT", "sim:?speed=5");
        here.Show("Job");
        here.Enter("CNCARM", "Stream");
        here.Click(here.Find<Avalonia.Controls.Button>("StartKey"));
        here.Until(() => here.Commands.Machine.Status is { State: MachineState.Running, Progress: { Fraction: > 0.82, ToolOn: true } } && here.Window.Model.Machine.Feed.Length > 2);
        Take(here, "running");
        Assert.Equal("RUNNING", here.Window.Model.Machine.State);
        Assert.InRange(here.Window.Canvas.EngravedMoves, 1, here.Window.Canvas.Overlay!.MoveCount - 1);
        here.Hands.Press(Key.Pause);
        here.Rest();
        here.Show("Alarms");
        Take(here, "stopped");
    });

    [Fact]
    public Task Where_is_the_controller() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "nameplate.dxf");
        here.Window.Model.Connect.Open();
        here.Window.Model.Connect.IsSerial = true;
        here.Window.Model.Connect.Device = "/dev/ttyUSB0";
        here.Step();
        here.Step();
        Take(here, "connect");
    });

    [Fact]
    public Task The_light_theme() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "clock-dial.dxf");
        here.Enter("THEME", "Light");
        here.Show("Contours");
        Take(here, "light");
        here.Show("Findings");
        here.Show("Properties");
        here.Enter("SELECT", "ALL", "");
        Take(here, "light-properties");
        here.Enter("THEME", "Dark");
    });

    [Theory]
    [InlineData(1.5)]
    [InlineData(2.0)]
    public Task Fine_screens(double scale) => fixture.WithOperator(here =>
    {
        here.Hands.Resize(new Size(1100, 720));
        here.Hands.SetScale(scale);
        Open(here, "gasket.dxf");
        here.Click(here.Find<Avalonia.Controls.MenuItem>("MachineMenu"));
        Take(here, FormattableString.Invariant($"scale-{scale * 100:0}"));
        here.Hands.Press(Key.Escape);
        here.Hands.SetScale(1.0);
    });

    /// <summary>A screen of 1366 x 768 pixels at 125 %, and one of 1280 x 720 at 150 %.</summary>
    [Theory]
    [InlineData(1366, 768, 1.25)]
    [InlineData(1280, 720, 1.5)]
    public Task Small_screens(int width, int height, double scale) => fixture.WithOperator(here =>
    {
        here.Hands.SetScale(scale);
        here.Hands.Resize(new Size(width / scale, height / scale));
        Open(here, "nameplate.dxf");
        here.Enter("CNCCONNECT", "sim:");
        here.Enter("HELP", "CNCARM");
        Take(here, FormattableString.Invariant($"screen-{width}-{scale * 100:0}"));
        here.Hands.SetScale(1.0);
    });

    [Fact]
    public Task The_theme_of_high_contrast() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "clock-dial.dxf");
        here.Enter("THEME", "HighContrast");
        here.Show("Job");
        here.Enter("CNCCONNECT", "sim:", "HELP", "");
        Take(here, "high-contrast");
        here.Enter("THEME", "Dark");
    });

    [Fact]
    public Task The_right_button_has_a_menu() => fixture.WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "nameplate.dxf");
        here.Enter("ZOOM", "E", "SELECT", "L", "");
        here.Hands.Click(here.MiddleOf(here.Window.Canvas), MouseButton.Right);
        here.Step();
        Take(here, "canvas-menu");
        here.Hands.Press(Key.Escape);
        here.Step();
    });

    /// <summary>By its name on the command line: a file dialog would give the full path.</summary>
    private static void Open(Operator here, string sample)
    {
        here.Commands.Settings.Change(settings => settings.WithVariable("FILEDIA", 0));
        here.Open(sample);
    }

    /// <summary>A picture must show the whole window at its scale, have more than one colour, and contain nothing specific to the computer it was taken
    /// on.</summary>
    private static void Take(Operator here, string name)
    {
        here.Until(() => here.Window.Canvas.IsFresh || here.Window.Canvas.Scene is null);
        here.Step();
        using var whole = new MemoryStream();
        here.Hands.CapturePng(whole);
        whole.Position = 0;
        using var pixels = PngFile.Read(whole);
        using var picture = new MemoryStream();
        PngFile.WriteIndexed(picture, pixels);
        Assert.InRange(picture.Length, 1, MostBytes);
        Assert.DoesNotContain(here.Window.GetVisualDescendants().OfType<Avalonia.Controls.TextBlock>(), text => text.IsEffectivelyVisible && text.Text?.Contains(RepositoryFolder.Root, StringComparison.Ordinal) == true);
        if (s_folder is not null) File.WriteAllBytes(Path.Combine(s_folder, name + ".png"), picture.ToArray());
        var canvas = here.MiddleOf(here.Window.Canvas);
        var strip = here.MiddleOf(here.Find<Avalonia.Controls.Control>("MachineStrip"));
        Assert.NotEqual(here.Hands.PixelAt((int)canvas.X, (int)canvas.Y), here.Hands.PixelAt((int)strip.X, 34));
    }
}
