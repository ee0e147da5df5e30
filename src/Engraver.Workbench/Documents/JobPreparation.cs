using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Machines;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>Runs the stages (<see cref="JobStages"/>) from a drawing to its motion program.</summary>
public static class JobPreparation
{
    /// <summary>Runs all stages up to the checked motion program.</summary>
    /// <param name="style">Continuous for streaming and posted sequences, calls for the subroutine calls of paper 000.</param>
    /// <param name="values">What the fields in its texts stand for; null for none.</param>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static PreparedJob Prepare(Drawing drawing, DrawingSettings settings, MotionStyle style, PlateValues? values = null) => PrepareUnlessCancelled(drawing, settings, style, CancellationToken.None, values);

    /// <summary>Runs all stages up to the checked motion program; cancellation is checked between them.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static PreparedJob PrepareUnlessCancelled(Drawing drawing, DrawingSettings settings, MotionStyle style, CancellationToken cancellation, PlateValues? values = null) =>
        PreparedJob.From(new StageRun(new DrawnJob(drawing, settings, style) { Values = values ?? PlateValues.None }, cancellation).To<CheckedJob>());

    /// <summary>Runs the stages up to the last one that returns <typeparamref name="T"/>.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static T To<T>(Drawing drawing, DrawingSettings settings, PlateValues? values = null)
        where T : DrawnJob => new StageRun(new DrawnJob(drawing, settings) { Values = values ?? PlateValues.None }, CancellationToken.None).To<T>();

    /// <summary>The fields in the texts that are cut.</summary>
    /// <exception cref="SettingException">A named layer is not in the drawing.</exception>
    public static PlateFields FieldsOf(Drawing drawing, DrawingSettings settings) => LetterStage.FieldsOf(drawing, settings);

    /// <summary>The fixed-slot table of the selected layers, arcs analysed, file order.</summary>
    /// <exception cref="SettingException">A named layer is not in the drawing.</exception>
    public static EntityTable Analyse(Drawing drawing, DrawingSettings settings, PlateValues? values = null) => To<AnalysedJob>(drawing, settings, values).Analysed;

    /// <summary>The cut table in cutting order, with the findings of the tool radius compensation.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static (EntityTable Table, IReadOnlyList<Diagnostic> Findings) CutTableOf(Drawing drawing, DrawingSettings settings, PlateValues? values = null)
    {
        var ordered = To<OrderedJob>(drawing, settings, values);
        return (ordered.Sequence.Table, [.. ordered.Cut.Kerf?.Diagnostics ?? [], .. ordered.Assignment?.Findings ?? [], .. ordered.OperationFaults]);
    }

    /// <summary>Findings on the drawing before it is cut: its texts, and <see cref="CutFindings"/>.</summary>
    /// <param name="job">A job that has not been inspected.</param>
    public static IReadOnlyList<Diagnostic> Findings(LetteredJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return [.. job.Findings, .. InspectStage.FindingsOf(job.Drawing, job.Settings)];
    }
}
