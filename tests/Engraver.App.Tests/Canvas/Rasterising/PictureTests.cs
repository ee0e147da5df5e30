using System.Net.Sockets;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Presenters;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.Simulator;
using Engraver.SoftwarePlatform.Bitmaps;
using Engraver.TestKit;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Canvas.Rasterising;

/// <summary>Pictures of the real program in the states an operator meets, compared pixel by pixel with the reviewed ones of docs/images, which the manual
/// shows. <c>./test --update-golden</c> writes those that differ; look at them before they are committed. Pictures of a machine that has moved depend on
/// the moments of the polls: docs/images/make writes them.</summary>
[Collection(DesktopCollection.Name)]
public sealed class PictureTests(DesktopFixture fixture)
{
    /// <summary>Limits the size of a manual with many pictures.</summary>
    private const int MaxBytes = 150_000;

    /// <summary>The alarm shows this port. It is below those that systems choose for outgoing connections.</summary>
    private const int Port = 21430;

    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(15);

    /// <summary>A picture to be kept has not changed for so long.</summary>
    private static readonly TimeSpan s_rest = TimeSpan.FromSeconds(1);

    private static readonly Size s_usual = new(1280, 800);
    private static readonly string s_reviewed = Path.Combine(RepositoryFolder.Root, "docs", "images");
    private static readonly string? s_folder = Environment.GetEnvironmentVariable("ENGRAVER_PICTURES");
    private static readonly string s_output = Path.Combine(RepositoryFolder.Root, "artifacts", "pictures");

    [Fact]
    public Task A_drawing_is_open() => WithOperator(here =>
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
    public Task The_doctor_has_findings() => WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "gasket.dxf");
        here.Enter("CHECK");
        here.Show("Findings");
        Take(here, "findings");
    });

    [Fact]
    public Task The_link_is_lost() => WithOperator(here =>
    {
        var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        here.Until(() => Listens(controller));
        here.Hands.Resize(s_usual);
        Open(here, "gasket.dxf");
        here.Enter("CNCCONNECT", FormattableString.Invariant($"tcp://127.0.0.1:{Port}"));
        var ending = controller.DisposeAsync().AsTask();
        here.Until(() => here.Commands.Machine.Alarms.Open.Count > 0 && ending.IsCompleted);
        here.Show("Alarms");
        TakeMoving(here, "alarm"); // The text is that of a closed or of a reset connection, as the system reports it.
    });

    [Fact]
    public Task The_playback_stands_in_the_middle() => WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "gasket.dxf");
        here.Show("Program");
        here.Show("Table");
        here.Window.Model.Playback.At = here.Window.Model.Playback.Total / 2;
        here.Step();
        Take(here, "playback");
    });

    [Fact]
    public Task A_run_is_plotted_over_its_plan() => WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "paper-001.dxf");
        here.Enter("CNCSIM");
        here.Show("Plots");
        here.Click(here.Find<Button>("PlotEnlargeButton"));
        here.Window.Model.Playback.At = here.Window.Model.Playback.Total / 3;
        here.Step();
        TakeMoving(here, "plots");
    });

    [Fact]
    public Task A_small_window_loses_nothing() => WithOperator(here =>
    {
        here.Hands.Resize(new Size(1024, 700));
        Open(here, "gasket.dxf");
        here.Enter("CNCCONNECT", "sim:");
        here.Hands.Type("Z");
        here.Step();
        Take(here, "small");
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
        here.Enter("MOVE");
        Take(here, "small-options");
    });

    [Fact]
    public Task A_machine_with_a_z_axis_is_commissioned() => WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        here.Enter("CNCPROFILE", "machine-mill.json", "CNCCONNECT", "sim:", "CNCMOTORS", "ON", "CNCJOG", "12,-4", "CNCJOG", "Z+", "11.5", "CNCZERO", "All", "CNCJOG", "Z-", "2.25");
        here.Show("Machine");
        TakeMoving(here, "machine-page");
        here.Show("Commissioning");
        here.Enter("CNCCOMMISSION", "Skip", "Skip");
        TakeMoving(here, "commissioning");
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
    });

    [Fact]
    public Task A_plate_with_three_tools_shows_each_operation_in_its_colour() => WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "finished-plate.dxf");
        here.Enter("CNCPROFILE", "machine-mill.json", "CNCCUT", "32", "OPERATION", "LOad", "finished-plate.operations.json");
        here.Show("Operations");
        here.Until(() => here.Window.Canvas.Overlay is { HasOperations: true });
        here.Enter("ZOOM", "Extents");
        Take(here, "operations");
    });

    [Fact]
    public Task The_simulated_machine_is_armed() => WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "nameplate.dxf");
        here.Enter("CNCCONNECT", "sim:");
        here.Show("Job");
        here.Enter("CNCARM", "Stream");
        Take(here, "armed");
    });

    [Fact]
    public Task A_job_runs_on_the_simulated_controller() => WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "nameplate.dxf");
        here.Enter("CNCCONNECT", "sim:?speed=5");
        here.Show("Job");
        here.Enter("CNCARM", "Stream");
        here.Click(here.Find<Button>("StartKey"));
        here.Until(() => here.Commands.Machine.Status is { State: MachineState.Running, Progress: { Fraction: > 0.82, ToolOn: true } } && here.Window.Model.Machine.Feed.Length > 2);
        TakeMoving(here, "running");
        Assert.Equal("RUNNING", here.Window.Model.Machine.State);
        Assert.InRange(here.Window.Canvas.EngravedMoves, 1, here.Window.Canvas.Overlay!.MoveCount - 1);
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();
        here.Show("Alarms");
        TakeMoving(here, "stopped");
    });

    [Fact]
    public Task Where_is_the_controller() => WithOperator(here =>
    {
        here.Hands.Resize(s_usual);
        Open(here, "nameplate.dxf");
        here.Window.Model.Connect.FindDevices = () => ["/dev/ttyUSB0", "/dev/ttyUSB1"];
        here.Window.Model.Connect.Open();
        here.Window.Model.Connect.IsSerial = true;
        here.Window.Model.Connect.Device = "/dev/ttyUSB0";
        here.Step();
        here.Step();
        Take(here, "connect");
    });

    [Fact]
    public Task The_light_theme() => WithOperator(here =>
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
    public Task Fine_screens(double scale) => WithOperator(here =>
    {
        here.Hands.Resize(new Size(1100, 720));
        here.Hands.SetScale(scale);
        Open(here, "gasket.dxf");
        here.Click(here.Find<MenuItem>("MachineMenu"));
        Take(here, FormattableString.Invariant($"scale-{scale * 100:0}"));
        here.Hands.Press(Key.Escape);
        here.Hands.SetScale(1.0);
    });

    /// <summary>A screen of 1366 x 768 pixels at 125 %, and one of 1280 x 720 at 150 %.</summary>
    [Theory]
    [InlineData(1366, 768, 1.25)]
    [InlineData(1280, 720, 1.5)]
    public Task Small_screens(int width, int height, double scale) => WithOperator(here =>
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
    public Task The_theme_of_high_contrast() => WithOperator(here =>
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
    public Task The_right_button_has_a_menu() => WithOperator(here =>
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

    /// <summary>Another test of the same port may run at the same time.</summary>
    private static bool Listens(SimulatedController controller)
    {
        try
        {
            return controller.ListenTcpAsync(Port, CancellationToken.None).IsCompletedSuccessfully;
        }
        catch (SocketException)
        {
            return false;
        }
    }

    /// <summary>The date is always the same.</summary>
    private Task WithOperator(Action<Operator> test) => fixture.WithOperator(test, clock: new SameDate());

    /// <summary>A picture must be the reviewed one. What changes of its own accord until it is at rest (a first poll, a bar that fades) is waited
    /// for.</summary>
    private static void Take(Operator here, string name)
    {
        Prepare(here);
        var reviewed = new ReviewedPicture(Path.Combine(s_reviewed, name + ".png"), s_output);
        if (GoldenFile.IsUpdating)
        {
            reviewed.Replace(AtRest(here));
            return;
        }

        var (picture, difference) = (Array.Empty<byte>(), default(PictureDifference));
        try
        {
            here.Until(() => (difference = reviewed.Compare(picture = Captured(here))) is null, s_patience);
        }
        catch (TimeoutException)
        {
            Assert.Fail(reviewed.Keep(picture, difference!));
        }

        Assert.InRange(picture.Length, 1, MaxBytes);
    }

    /// <summary>A picture of a machine that moves or has left a trail, whose points are those of the polls: it must show the window and not be one colour. With
    /// ENGRAVER_PICTURES it is kept in that folder.</summary>
    private static void TakeMoving(Operator here, string name)
    {
        Prepare(here);
        var picture = Captured(here);
        Assert.InRange(picture.Length, 1, MaxBytes);
        if (s_folder is not null) File.WriteAllBytes(Path.Combine(s_folder, name + ".png"), picture);
        var (canvas, strip) = (here.MiddleOf(here.Window.Canvas), here.MiddleOf(here.Find<Control>("MachineStrip")));
        Assert.NotEqual(here.Hands.PixelAt((int)canvas.X, (int)canvas.Y), here.Hands.PixelAt((int)strip.X, 34));
    }

    /// <summary>The canvas is drawn, the caret does not blink, and no text names the machine on which the picture is taken.</summary>
    private static void Prepare(Operator here)
    {
        foreach (var text in here.Window.GetVisualDescendants().OfType<TextPresenter>())
        {
            text.CaretBlinkInterval = TimeSpan.Zero;
            if (text.FindAncestorOfType<TextBox>()?.IsFocused == true) text.ShowCaret();
        }

        here.Until(() => here.Window.Canvas.IsUpToDate || here.Window.Canvas.Scene is null);
        here.Step();
        var shown = here.Window.GetVisualDescendants().OfType<TextBlock>().Where(text => text.IsEffectivelyVisible && text.Text is not null).Select(text => text.Text!);
        Assert.DoesNotContain(shown, text => new[] { RepositoryFolder.Root, Path.GetTempPath() }.Any(own => text.Contains(own, StringComparison.Ordinal)));
    }

    private static byte[] AtRest(Operator here)
    {
        var (picture, since) = (Captured(here), TimeProvider.System.GetTimestamp());
        here.Until(() =>
        {
            var now = Captured(here);
            if (!now.AsSpan().SequenceEqual(picture)) (picture, since) = (now, TimeProvider.System.GetTimestamp());
            return TimeProvider.System.GetElapsedTime(since) > s_rest;
        });
        return picture;
    }

    private static byte[] Captured(Operator here)
    {
        using var whole = new MemoryStream();
        here.Hands.CapturePng(whole);
        whole.Position = 0;
        using var pixels = PngFile.Read(whole);
        using var picture = new MemoryStream();
        PngFile.WriteIndexed(picture, pixels);
        return picture.ToArray();
    }

    /// <summary>A clock that runs and always names the same date, in no zone.</summary>
    private sealed class SameDate : TimeProvider
    {
        public override TimeZoneInfo LocalTimeZone => TimeZoneInfo.Utc;

        public override DateTimeOffset GetUtcNow() => new(2026, 11, 27, 9, 30, 0, TimeSpan.Zero);
    }
}
