namespace Engraver.Workbench.Plots;

/// <summary>Draws plots into a picture. Only the desktop has one, so that the console runner needs no graphics library.</summary>
public interface IPlotRenderer
{
    /// <summary>Writes a picture in PNG format.</summary>
    /// <param name="width">Pixels.</param>
    /// <param name="height">Pixels.</param>
    void WritePng(PlotContent content, int width, int height, Stream output);

    /// <summary>Writes a picture in SVG format.</summary>
    /// <param name="width">Units of the picture, usually shown as pixels.</param>
    /// <param name="height">As <paramref name="width"/>.</param>
    void WriteSvg(PlotContent content, int width, int height, TextWriter output);
}
