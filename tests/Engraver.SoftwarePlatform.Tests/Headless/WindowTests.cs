using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Threading;
using Engraver.SoftwarePlatform.Headless;

namespace Engraver.SoftwarePlatform.Tests.Headless;

[Collection(DesktopCollection.Name)]
public sealed class WindowTests(DesktopFixture fixture)
{
    private static readonly TimeSpan Timeout = TimeSpan.FromSeconds(60);

    /// <summary>Also when the renderer has not drawn an earlier change yet.</summary>
    [Fact]
    public Task After_a_step_the_window_shows_what_was_wanted_before_it() => fixture.Runner.RunAsync(() =>
    {
        var window = new Window { Width = 60, Height = 40, Background = Brushes.White };
        window.Show();
        fixture.Desktop.Step();
        foreach (var colour in new[] { Colors.Red, Colors.Lime, Colors.Blue })
        {
            window.Background = Brushes.Gray;
            Dispatcher.UIThread.RunJobs();
            window.Background = new SolidColorBrush(colour);
            fixture.Desktop.Step();
            Assert.Equal(colour, fixture.Desktop.Windows[^1].PixelAt(30, 20));
        }

        window.Close();
        return Task.CompletedTask;
    });

    [Fact]
    public Task A_modal_dialog_stops_its_owner_and_gives_its_answer() => fixture.Runner.RunAsync(async () =>
    {
        var demo = new DemoWindow();
        demo.Show();
        fixture.Desktop.Step();
        var owner = fixture.Desktop.Windows[^1];
        var yes = new Button { Content = "Yes", IsDefault = true };
        var dialog = new Window { Width = 200, Height = 100, Content = yes };
        yes.Click += (_, _) => dialog.Close("yes");
        var answer = dialog.ShowDialog<string>(demo);
        fixture.Desktop.Step();
        var hands = fixture.Desktop.Windows[^1];
        Assert.NotSame(owner, hands);
        Assert.Same(hands, fixture.Desktop.ActiveWindow);

        owner.Click(demo.Middle(demo.Counter));
        Assert.Equal(0, demo.Presses);
        hands.Press(Key.Enter);
        Assert.Equal("yes", await answer);
        Assert.Same(owner, fixture.Desktop.ActiveWindow);

        owner.Click(demo.Middle(demo.Counter));
        Assert.Equal(1, demo.Presses);
        demo.Close();
    });

    /// <summary>Handled signals must not keep the dispatcher from waiting, because other threads need the processor.</summary>
    [Fact]
    public Task A_desktop_that_has_nothing_to_do_waits() => fixture.WithDemo((demo, _) =>
    {
        var asked = 0;
        Dispatcher.UIThread.Post(() => demo.Title = "posted");
        Dispatcher.UIThread.Post(() => demo.Title = "posted later", DispatcherPriority.Background);

        Assert.Throws<TimeoutException>(() => fixture.Desktop.StepUntil(() => ++asked > 200, TimeSpan.FromSeconds(0.3)));
        Assert.Equal("posted later", demo.Title);
    });

    [Fact]
    public Task The_picture_follows_size_and_scale() => fixture.WithDemo((demo, hands) =>
    {
        hands.Resize(new Size(640, 400));
        Assert.Equal(new Size(640, 400), demo.ClientSize);
        hands.SetScale(1.5);
        using var file = new MemoryStream();
        hands.CapturePng(file);
        file.Position = 0;
        using var picture = new Bitmap(file);

        Assert.Equal(new PixelSize(960, 600), picture.PixelSize);
        Assert.Equal(new Size(640, 400), demo.ClientSize);
        Assert.Equal(hands.PixelAt(0, 599), hands.PixelAt(959, 599)); // the background reaches the corners
        Assert.Equal(255, hands.PixelAt(959, 599).A);
    });

    [Fact]
    public Task Only_the_active_window_knows_that_it_is() => fixture.WithDemo((demo, hands) =>
    {
        Assert.True(demo.IsActive);
        hands.LoseFocus();
        Assert.False(demo.IsActive);
        demo.Activate();
        fixture.Desktop.Step();
        Assert.True(demo.IsActive);
    });

    [Fact]
    public Task Closing_can_be_refused() => fixture.WithDemo((demo, hands) =>
    {
        demo.Closing += Refuse;
        hands.RequestClose();
        Assert.Contains(hands, fixture.Desktop.Windows);

        demo.Closing -= Refuse;
        hands.RequestClose();
        Assert.DoesNotContain(hands, fixture.Desktop.Windows);
    });

    [Fact]
    public Task A_dispatcher_timer_ends_a_wait() => fixture.WithDemo((_, _) =>
    {
        var rung = false;
        DispatcherTimer.RunOnce(() => rung = true, TimeSpan.FromMilliseconds(30));
        fixture.Desktop.StepUntil(() => rung, Timeout);

        Assert.True(rung);
    });

    [Fact]
    public Task A_wait_in_vain_is_an_exception() => fixture.WithDemo((_, _) =>
        Assert.Throws<TimeoutException>(() => fixture.Desktop.StepUntil(() => false, TimeSpan.FromMilliseconds(1))));

    /// <summary>The order proves it: the filter has been called and the key is queued before the user interface is released.</summary>
    [Fact]
    public async Task The_key_filter_is_called_while_the_user_interface_is_blocked()
    {
        var filtered = new List<Key>();
        var received = new List<Key>();
        using var blocked = new ManualResetEventSlim();
        using var release = new ManualResetEventSlim();
        HeadlessWindow? hands = null;
        var test = fixture.WithDemo((demo, window) =>
        {
            hands = window;
            fixture.Filter = (in KeyPress press) => See(filtered, press);
            demo.KeyDown += (_, e) => received.Add(e.Key);
            blocked.Set();
            release.Wait();
            fixture.Desktop.Step();
        });
        await Task.Run(blocked.Wait);
        hands!.Press(Key.Pause);
        hands.Press(Key.F5);
        Assert.Equal([Key.Pause, Key.F5], filtered);
        Assert.Empty(received);

        release.Set();
        await test;
        Assert.Equal([Key.F5], received);
    }

    [Fact]
    public async Task A_region_answers_while_the_user_interface_is_blocked()
    {
        var stops = 0;
        using var blocked = new ManualResetEventSlim();
        using var release = new ManualResetEventSlim();
        HeadlessWindow? hands = null;
        var test = fixture.WithDemo((demo, window) =>
        {
            hands = window;
            using var region = fixture.Regions.Add(demo, new Rect(400, 300, 200, 100), () => ++stops > 0);
            blocked.Set();
            release.Wait();
        });
        await Task.Run(blocked.Wait);
        hands!.PressButton(new Point(500, 350));
        hands.PressButton(new Point(700, 350));
        Assert.Equal(1, stops);

        release.Set();
        await test;
    }

    private static void Refuse(object? sender, WindowClosingEventArgs e) => e.Cancel = true;

    private static bool See(List<Key> filtered, in KeyPress press)
    {
        if (press.IsDown) filtered.Add(press.Key);
        return press.Key == Key.Pause;
    }
}
