using Engraver.Core.Drawings;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Makes curves of the texts on the selected layers, if the settings request it.</summary>
internal sealed class LetterStage() : JobStage<DrawnJob, LetteredJob>("Letter", share: 2)
{
    public override IReadOnlyList<Setting> Settings => [SettingTable.Cut, SettingTable.Layers, SettingTable.SkippedLayers, SettingTable.MaxError];

    /// <summary>Part of the maximum error for the arcs of outlines that are united; the rest is for the path.</summary>
    private const double ErrorShare = 0.25;

    public override bool StartsStep => false;

    public override bool IsMeasured => false; // The measured drawing has no text.

    protected override LetteredJob Execute(DrawnJob job, CancellationToken cancellation)
    {
        if (!job.Settings.Cut.HasFlag(CutChoice.Text) || job.Drawing.Texts.Count == 0) return new LetteredJob(job, LetteredDrawing.None(job.Drawing));
        var taken = StageOptions.SelectionOf(job.Settings).Taken(job.Drawing.Layers);
        var letters = LetteredDrawing.Of(job.Drawing, text => !text.Hidden && taken[text.Layer], LetterLibrary.FontsOf(job.Drawing), job.Drawing.Scale.ToDrawing(ErrorShare * job.Settings.MaxErrorMm), cancellation);
        return new LetteredJob(job with { Drawing = letters.Drawing, Findings = [.. job.Findings, .. letters.Findings] }, letters);
    }
}
