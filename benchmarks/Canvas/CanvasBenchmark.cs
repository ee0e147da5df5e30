using System.Diagnostics;
using System.Globalization;
using Avalonia;
using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Picking;
using Engraver.App.Canvas.Rasterising;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Canvas.Views;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Benchmarks.Canvas;

/// <summary>Measures the canvas: scene, first picture, a moved frame, a refined frame after panning and zooming, picking. Wall time (best and median),
/// because the operator waits for a picture, and processor time of all cores (best), because wall time depends on what else the computer does.</summary>
public static class CanvasBenchmark
{
    private const int Repetitions = 7;
    private static readonly PixelSize s_size = new(1600, 1000);

    /// <summary>Writes a Markdown table, one row for each stage.</summary>
    /// <param name="sizes">Numbers of segments.</param>
    public static void Run(IEnumerable<int> sizes, TextWriter output)
    {
        ArgumentNullException.ThrowIfNull(sizes);
        ArgumentNullException.ThrowIfNull(output);
        Measure(2000, TextWriter.Null); // compiles the code, so that the just-in-time compiler is not measured
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"Canvas {s_size.Width} x {s_size.Height} pixels, {Environment.ProcessorCount} cores"));
        output.WriteLine("| Segments | Stage | best ms | median ms | best CPU ms | note |");
        output.WriteLine("|---:|---|---:|---:|---:|---|");
        foreach (var size in sizes) Measure(size, output);
    }

    private static void Measure(int segments, TextWriter output)
    {
        var drawing = BenchmarkDrawing.Create(segments);
        var scene = Timed(output, segments, "scene from drawing", () => CanvasScene.From(drawing), made => $"{made.Store.Bytes / (double)made.PrimitiveCount:0} bytes/segment");
        var all = CanvasView.Fitting(scene.Extents, s_size);
        var picture = Timed(output, segments, "whole picture", () => Render(scene, all), _ => "");
        var target = new uint[s_size.Width * s_size.Height];
        Timed(output, segments, "moved at once (pan)", () => Move(picture, all.PannedBy(new Vector2D(37.0, -20.0)), target), _ => "");
        Timed(output, segments, "moved at once (zoom)", () => Move(picture, all.ZoomedAbout(new Point2D(500.0, 300.0), 1.6), target), _ => "");
        Timed(output, segments, "refined after pan", () => Render(scene, all.PannedBy(new Vector2D(37.0, -20.0))), _ => "");
        foreach (var zoom in new[] { 4.0, 64.0, 1e6 }) Timed(output, segments, $"refined at zoom {zoom:g}", () => Render(scene, all.ZoomedAbout(new Point2D(500.0, 300.0), zoom)), _ => "");
        MeasurePath(scene, all, output, segments);
        MeasurePicks(drawing, scene, all, output, segments);
    }

    /// <summary>The drawing with everything selected under a cut path of the same length, half of it engraved.</summary>
    private static void MeasurePath(CanvasScene scene, CanvasView view, TextWriter output, int segments)
    {
        var (palette, selected) = (scene.Colours.PaletteFor(CanvasTheme.Dark), new bool[scene.Drawing.Entities.Count]);
        Array.Fill(selected, true);
        IPictureLayer[] layers =
        [
            new PrimitiveLayer(scene.Store, palette, LinePen.Hairline),
            new PrimitiveLayer(scene.Store, [CanvasTheme.Dark.Selected], new LinePen(2.0)) { EntityFilter = selected },
            new PrimitiveLayer(scene.Store, [CanvasTheme.Dark.Engraved, CanvasTheme.Dark.Remaining], new LinePen(2.0)) { FirstRemaining = selected.Length / 2 },
        ];
        Timed(output, segments, "with selection and path", () => PictureRenderer.Render(layers, view, Backdrop.For(view, CanvasTheme.Dark, grid: true), CancellationToken.None), _ => "all selected, as many moves as segments");
    }

    private static void MeasurePicks(Drawing drawing, CanvasScene scene, CanvasView view, TextWriter output, int segments)
    {
        var place = view.ToDrawing(new Point2D(700.0, 430.0));
        Timed(output, segments, "pick", () => ScenePick.Nearest(scene, place, 3.0 * view.UnitsPerPixel), found => $"entity {found}");
        Timed(output, segments, "window, all", () => SceneSelection.Inside(scene, scene.Extents.Grown(1.0)).Count, found => $"{found} of {drawing.Entities.Count}");
        Timed(output, segments, "crossing, a tenth", () => SceneSelection.Touching(scene, view.WindowOf(500.0, 300.0, 160.0, 100.0)).Count, found => $"{found} found");
    }

    private static Picture Render(CanvasScene scene, CanvasView view)
    {
        var layer = new PrimitiveLayer(scene.Store, scene.Colours.PaletteFor(CanvasTheme.Dark), LinePen.Hairline);
        return PictureRenderer.Render([layer], view, Backdrop.For(view, CanvasTheme.Dark, grid: true), CancellationToken.None);
    }

    private static int Move(Picture picture, CanvasView view, uint[] target)
    {
        PictureMover.Move(picture, view, CanvasTheme.Dark.Background, target, s_size.Width);
        return target.Length;
    }

    private static T Timed<T>(TextWriter output, int segments, string stage, Func<T> run, Func<T, string> note)
    {
        var times = new double[Repetitions];
        var busy = double.PositiveInfinity;
        T result = default!;
        for (var i = 0; i < Repetitions; i++)
        {
            var (start, cpu) = (Stopwatch.GetTimestamp(), Environment.CpuUsage.TotalTime);
            result = run();
            times[i] = Stopwatch.GetElapsedTime(start).TotalMilliseconds;
            busy = Math.Min(busy, (Environment.CpuUsage.TotalTime - cpu).TotalMilliseconds);
        }

        Array.Sort(times);
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"| {segments} | {stage} | {times[0]:0.00} | {times[Repetitions / 2]:0.00} | {busy:0.0} | {note(result)} |"));
        return result;
    }
}
