using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Machines;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>Runs the stages (<see cref="JobStages"/>) from a drawing to its motion program.</summary>
public static class JobPreparation
{
    /// <summary>Runs all stages up to the checked motion program.</summary>
    /// <param name="style">Continuous for streaming and posted sequences, calls for the subroutine calls of paper 000.</param>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static PreparedJob Prepare(Drawing drawing, DrawingSettings settings, MotionStyle style) => PrepareUnlessCancelled(drawing, settings, style, CancellationToken.None);

    /// <summary>Runs all stages up to the checked motion program; cancellation is checked between them.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static PreparedJob PrepareUnlessCancelled(Drawing drawing, DrawingSettings settings, MotionStyle style, CancellationToken cancellation) =>
        PreparedJob.From(new StageRun(new DrawnJob(drawing, settings, style), cancellation).To<CheckedJob>());

    /// <summary>Runs the stages up to the last one that returns <typeparamref name="T"/>.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static T To<T>(Drawing drawing, DrawingSettings settings)
        where T : DrawnJob => new StageRun(new DrawnJob(drawing, settings), CancellationToken.None).To<T>();

    /// <summary>The fixed-slot table of the selected layers, arcs analysed, file order.</summary>
    /// <exception cref="SettingException">A named layer is not in the drawing.</exception>
    public static EntityTable Analyse(Drawing drawing, DrawingSettings settings) => To<AnalysedJob>(drawing, settings).Analysed;

    /// <summary>The cut table in cutting order, with the findings of the tool radius compensation.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static (EntityTable Table, IReadOnlyList<Diagnostic> Findings) CutTableOf(Drawing drawing, DrawingSettings settings)
    {
        var ordered = To<OrderedJob>(drawing, settings);
        return (ordered.Sequence.Table, ordered.Cut.Kerf?.Diagnostics ?? []);
    }

    /// <summary>Findings on the drawing before it is cut: its texts, and <see cref="CutFindings"/>.</summary>
    /// <param name="job">A job that has not been inspected.</param>
    public static IReadOnlyList<Diagnostic> Findings(LetteredJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return [.. job.Findings, .. InspectStage.FindingsOf(job.Drawing, job.Settings)];
    }
}
