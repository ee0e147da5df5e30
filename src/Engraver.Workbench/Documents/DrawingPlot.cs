using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Plots;
using Engraver.Core.Verification;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Sidecars;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>Plots of a drawing, of its path, trajectories or runs.</summary>
public static class DrawingPlot
{
    /// <param name="asDrawn">True: curves in file order, no path.</param>
    /// <param name="values">What the fields in its texts stand for; null for none.</param>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static PlotModel Create(Drawing drawing, DrawingSettings settings, bool asDrawn, PlateValues? values = null)
    {
        var title = Path.GetFileName(drawing.FileName);
        if (asDrawn) return PlotModel.FromDrawing(JobPreparation.Analyse(drawing, settings, values), title);
        return PlotModel.FromPath(JobPreparation.To<PathJob>(drawing, settings, values).Toolpath, title);
    }

    /// <summary>All plates of a series, each at its place.</summary>
    /// <param name="asDrawn">True: curves in file order, no path.</param>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing, or a cell is outside the range of a drawing.</exception>
    public static PlotModel OfPlates(Drawing drawing, DrawingSettings settings, bool asDrawn, IReadOnlyList<Plate> plates)
    {
        ArgumentNullException.ThrowIfNull(plates);
        var title = Path.GetFileName(drawing.FileName);
        List<PlotModel> models = [.. plates.Select(ModelOf)];
        return models[0] with { Strokes = [.. models.SelectMany(model => model.Strokes)], Rapids = [.. models.SelectMany(model => model.Rapids)] };

        PlotModel ModelOf(Plate plate)
        {
            var run = new StageRun(PlateJob.Drawn(drawing, settings, MotionStyle.Continuous, plate), CancellationToken.None);
            return asDrawn ? PlotModel.FromDrawing(run.To<AnalysedJob>().Analysed, title) : PlotModel.FromPath(run.To<PathJob>().Toolpath, title);
        }
    }

    /// <summary>Trajectories over the drawing: those of the document or of the sidecar, otherwise one along each contour.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static (PlotModel Plot, IReadOnlyList<Diagnostic> Findings) OfTrajectories(Drawing drawing, DrawingSettings settings, IReadOnlyList<DocumentTrajectory>? known)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        var (trajectories, findings) = known is { Count: > 0 } ? (known, []) : TrajectoryJob.Find(drawing, settings);
        return (TrajectoryPlot.Create(JobPreparation.Analyse(drawing, settings), [.. trajectories.Select(one => one.Curve)], Path.GetFileName(drawing.FileName)), findings);
    }

    /// <summary>A run over the drawing.</summary>
    /// <exception cref="SettingException">A named layer is not in the drawing.</exception>
    /// <exception cref="FormatException">The run belongs to another drawing, or its following error was not recorded.</exception>
    public static PlotModel OfRun(Drawing drawing, DrawingSettings settings, RunTrace trace, RunMeasure measure)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(trace);
        var (analysed, name) = ((settings.Operations is null ? JobPreparation.To<CompensatedJob>(drawing, settings) : JobPreparation.To<OrderedJob>(drawing, settings)).Cut.Table, Path.GetFileName(drawing.FileName));
        if (!trace.CanBeOf(DrawnFingerprint.Of(analysed.ToSegments()))) throw new FormatException(Wording.Get("Trace.OtherDrawing", name));
        if (measure == RunMeasure.Following && !trace.HasFollowing) throw new FormatException(Wording.Get("Trace.NoFollowingError"));
        return RunPlot.Create(analysed, trace, measure, name);
    }
}
