using Avalonia;
using Avalonia.Controls;
using Engraver.SoftwarePlatform.Headless;

namespace Engraver.SoftwarePlatform.Tests.Headless;

/// <summary>Pictures of the demo window, stored beside the test assembly for review; what can be checked automatically is asserted.</summary>
[Collection(DesktopCollection.Name)]
public sealed class PictureTests(DesktopFixture fixture)
{
    private static readonly TimeSpan Timeout = TimeSpan.FromSeconds(60);
    private static readonly string s_folder = Path.Combine(AppContext.BaseDirectory, "pictures");

    [Fact]
    public Task Every_control_leaves_its_mark() => fixture.WithDemo((demo, hands) =>
    {
        hands.Click(demo.Middle(demo.Entry));
        hands.Type("Größe 12.5 mm ✓ fi AV");
        fixture.Desktop.Step();
        Save(hands, "demo.png");

        foreach (var control in new Control[] { demo.Counter, demo.Entry, demo.Choice, demo.Feed, demo.Rows, demo.File }) Assert.True(ColoursIn(demo, hands, control) > 3, $"{control} shows nothing");
    });

    [Fact]
    public Task A_menu_and_a_list_lie_over_the_window() => fixture.WithDemo((demo, hands) =>
    {
        var under = new PixelPoint(40, 90);
        var before = hands.PixelAt(under.X, under.Y);
        hands.Click(demo.Middle(demo.File));
        fixture.Desktop.StepUntil(() => hands.PixelAt(under.X, under.Y) != before, Timeout);
        Save(hands, "menu.png");
    });

    [Fact]
    public Task At_one_and_a_half_everything_is_drawn_larger() => fixture.WithDemo((demo, hands) =>
    {
        hands.SetScale(1.5);
        hands.Click(demo.Middle(demo.Choice));
        fixture.Desktop.Step();
        fixture.Desktop.Step();
        Save(hands, "scale-150.png");

        Assert.Equal(new PixelSize(1200, 780), hands.PixelSize);
        Assert.True(ColoursIn(demo, hands, demo.Counter) > 3);
    });

    private static int ColoursIn(Window window, HeadlessWindow hands, Control control)
    {
        var area = new Rect(control.TranslatePoint(default, window)!.Value, control.Bounds.Size);
        var pixels = PixelRect.FromRect(area, hands.RenderScaling);
        var colours = new HashSet<uint>();
        for (var y = pixels.Y; y < pixels.Bottom; y++)
        {
            for (var x = pixels.X; x < pixels.Right; x++) colours.Add(hands.PixelAt(x, y).ToUInt32());
        }

        return colours.Count;
    }

    private static void Save(HeadlessWindow hands, string name)
    {
        Directory.CreateDirectory(s_folder);
        hands.CaptureToFile(Path.Combine(s_folder, name));
    }
}
