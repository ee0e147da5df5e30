using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Fills the fields in the texts on the selected layers and makes curves of these texts, if the settings request it.</summary>
internal sealed class LetterStage() : JobStage<DrawnJob, LetteredJob>("Letter", share: 0)
{
    /// <summary>Part of the maximum error for the arcs of outlines that are united; the rest is for the path.</summary>
    private const double ErrorShare = 0.25;

    public override IReadOnlyList<Setting> Settings => [SettingTable.Cut, SettingTable.Layers, SettingTable.SkippedLayers, SettingTable.MaxError];

    public override bool StartsStep => false;

    public override bool IsMeasured => false; // The measured drawing has no text.

    /// <summary>The fields in the texts that are cut; none if no text is.</summary>
    public static PlateFields FieldsOf(Drawing drawing, DrawingSettings settings) =>
        PlateFields.Of(settings.Cut.HasFlag(CutChoice.Text) ? drawing.Texts.Where(TakenBy(drawing, settings)) : []);

    protected override LetteredJob Execute(DrawnJob job, CancellationToken cancellation)
    {
        if (!job.Settings.Cut.HasFlag(CutChoice.Text) || job.Drawing.Texts.Count == 0) return new LetteredJob(job, LetteredDrawing.None(job.Drawing));
        var isTaken = TakenBy(job.Drawing, job.Settings);
        var fields = FieldsOf(job.Drawing, job.Settings).Check(job.Values).ToLookup(finding => finding.Severity == Severity.Error);
        var letters = LetteredDrawing.Of(FilledTexts.Of(job.Drawing, job.Values), isTaken.Invoke, LetterLibrary.FontsOf(job.Drawing), job.Drawing.Scale.ToDrawing(ErrorShare * job.Settings.MaxErrorMm), cancellation);
        return new LetteredJob(job with { Drawing = letters.Drawing, Findings = [.. job.Findings, .. letters.Findings, .. fields[false]] }, letters) { FieldFaults = [.. fields[true]] };
    }

    /// <summary>True for a visible text on a selected layer.</summary>
    internal static Func<PlacedText, bool> TakenBy(Drawing drawing, DrawingSettings settings)
    {
        var layers = StageOptions.SelectionOf(settings).Taken(drawing.Layers);
        return text => !text.Hidden && layers[text.Layer];
    }
}
