using Avalonia;
using Avalonia.Controls;
using Engraver.SoftwarePlatform.Tests.X11;
using Engraver.TestKit;

namespace Engraver.App.Tests.RealWindow;

/// <summary>The complete workflow of an operator in a real window: keyboard, mouse, window manager, and a job to its end.</summary>
[Collection(DesktopCollection.Name)]
public sealed class RealJobTests(DesktopFixture fixture)
{
    /// <summary>Twenty times real time: at speed 1 the part takes longer than the test waits for a title on a busy computer.</summary>
    private const string Machine = "sim:?speed=20";

    private static readonly Size s_size = new(1200, 760);

    [XServerFact]
    public async Task A_job_is_opened_typed_armed_and_started_by_hand()
    {
        var (arm, start, canvas) = await PlacesAsync();
        using var desktop = new ShownDesktop();
        desktop.Enter("OPEN", Path.Combine(RepositoryFolder.Samples, "nameplate.dxf"));
        desktop.WaitForTitle("nameplate.dxf - CNC");
        desktop.Enter("CNCCONNECT", Machine);
        desktop.WaitForTitle("nameplate.dxf - READY");
        desktop.Settle(); // the title changes before the command has ended
        desktop.ClickUntil(arm, "nameplate.dxf - ARMED");
        desktop.Press("Return"); // starts nothing: there is only one journal at the end
        desktop.Press("Escape");
        desktop.Click(start);
        desktop.WaitForTitle("nameplate.dxf - DONE");

        var journal = Assert.Single(Directory.GetFiles(desktop.Journals, "nameplate-*.jsonl"));
        var end = File.ReadLines(journal).Last();
        Assert.Contains("\"kind\":\"end\"", end, StringComparison.Ordinal);
        Assert.Contains("\"outcome\":\"complete\"", end, StringComparison.Ordinal);
        LookAt(desktop, canvas);
        Assert.Equal(0, desktop.Close());
    }

    /// <summary>The frame of the simulation is around the window, and the drawing is in its middle.</summary>
    private static void LookAt(ShownDesktop desktop, Rect canvas)
    {
        var (screen, corner) = (desktop.Screen(), desktop.Corner());
        var frame = screen.At(corner.X + 1, corner.Y + ((int)s_size.Height / 2));
        Assert.NotEqual(0, frame);
        Assert.Equal(frame, screen.At(corner.X + 1, corner.Y + ((int)s_size.Height * 3 / 4)));
        Assert.NotEqual(frame, screen.At(corner.X + (int)canvas.Center.X, corner.Y + (int)canvas.Bottom + 10));
        Assert.True(screen.Drawn(corner.X + (int)canvas.X, corner.Y + (int)canvas.Y, (int)canvas.Width, (int)canvas.Height) > 2000, "no drawing on the screen");
    }

    /// <summary>Positions of controls are taken from the same window in memory.</summary>
    private async Task<(Point Arm, Point Start, Rect Canvas)> PlacesAsync()
    {
        var places = default((Point, Point, Rect));
        await fixture.WithOperator(here =>
        {
            here.Hands.Resize(s_size);
            here.Enter("CNCCONNECT", Machine);
            var canvas = new Rect(here.Window.Canvas.Bounds.Size).TransformToAABB(here.Window.Canvas.TransformToVisual(here.Window)!.Value);
            places = (here.MiddleOf(here.Find<Button>("ArmKey")), here.MiddleOf(here.Find<Button>("StartKey")), canvas);
        });
        return places;
    }
}
