using Avalonia.Controls;
using Engraver.App.Canvas;
using Engraver.App.Canvas.Scenes;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.SoftwarePlatform.Headless;
using Engraver.Workbench.Views;

namespace Engraver.App.Tests.Canvas;

/// <summary>A canvas alone in a window of 400 x 300: 300 drawing units high, the origin in its middle.</summary>
internal static class CanvasHost
{
    public static Task WithAsync(DesktopFixture fixture, Drawing drawing, Action<DrawingCanvas, ViewSession, HeadlessWindow, RecordedCommands> test) => fixture.Runner.RunAsync(() =>
    {
        var (view, heard) = (new ViewSession(), new RecordedCommands());
        view.Change(state => state with { Grid = false, Shown = CanvasLayers.Drawing });
        var canvas = new DrawingCanvas { View = view, Scene = CanvasScene.From(drawing), Commands = heard };
        var window = new Window { Width = 400.0, Height = 300.0, Content = canvas };
        window.Show();
        fixture.Desktop.Step();
        view.SetCentre(Point2D.Origin, 300.0);
        fixture.Desktop.Step();
        try
        {
            test(canvas, view, fixture.Desktop.Windows[^1], heard);
        }
        finally
        {
            window.Close();
            fixture.Desktop.Step();
        }

        return Task.CompletedTask;
    });
}
