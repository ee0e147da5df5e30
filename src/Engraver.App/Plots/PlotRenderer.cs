using System.Text;
using Avalonia;
using Avalonia.Styling;
using Avalonia.Threading;
using Engraver.Workbench.Plots;
using ScottPlot;
using SkiaSharp;
using PixelRect = ScottPlot.PixelRect;

namespace Engraver.App.Plots;

/// <summary>Draws plots into files, in the colours of the light theme, which are also legible on paper.</summary>
internal sealed class PlotRenderer : IPlotRenderer
{
    public void WritePng(PlotContent content, int width, int height, Stream output) => Draw(content, width, height, plots =>
    {
        using var surface = SKSurface.Create(new SKImageInfo(width, height));
        plots.Render(surface.Canvas, new PixelRect(0.0f, width, height, 0.0f));
        using var image = surface.Snapshot();
        using var data = image.Encode(SKEncodedImageFormat.Png, 100);
        data.SaveTo(output);
    });

    public void WriteSvg(PlotContent content, int width, int height, TextWriter output) => Draw(content, width, height, plots =>
    {
        using var memory = new MemoryStream();
        using (var canvas = SKSvgCanvas.Create(new SKRect(0.0f, 0.0f, width, height), memory)) plots.Render(canvas, new PixelRect(0.0f, width, height, 0.0f));
        output.Write(Encoding.UTF8.GetString(memory.ToArray()));
    });

    /// <summary>Commands run on a thread of their own; resources and fonts belong to the UI thread.</summary>
    private static void Draw(PlotContent content, int width, int height, Action<Multiplot> draw)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(width);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(height);
        Dispatcher.UIThread.Invoke(() =>
        {
            var plots = PlotPicture.Create(content, PlotColours.Of(Application.Current!, ThemeVariant.Light), 1.0, hasLegend: true);
            draw(plots);
            foreach (var plot in plots.Subplots.GetPlots()) plot.Dispose();
        });
    }
}
