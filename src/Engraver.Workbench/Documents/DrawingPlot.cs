using Engraver.Core.Drawings;
using Engraver.Core.Plots;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>The picture of a drawing, or of the path over it.</summary>
public static class DrawingPlot
{
    /// <param name="asDrawn">True: curves in file order, no path.</param>
    /// <exception cref="SettingException">A named layer or the entering entity is not in the drawing.</exception>
    public static PlotModel Create(Drawing drawing, DrawingSettings settings, bool asDrawn)
    {
        var title = Path.GetFileName(drawing.FileName);
        var analysed = JobPreparation.Analyse(drawing, settings);
        return asDrawn
            ? PlotModel.FromDrawing(analysed, title)
            : PlotModel.FromPath(JobPreparation.PathOf(JobPreparation.Sequence(drawing, analysed, settings), settings), title);
    }
}
