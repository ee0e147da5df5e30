using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Operations;
using Engraver.Core.Toolpaths;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Adds the findings about the drawing (<see cref="CutFindings"/>) and about the tool radius compensation.</summary>
internal sealed class InspectStage() : JobStage<CheckedJob, CheckedJob>("Inspect", share: 0)
{
    public override IReadOnlyList<Setting> Settings =>
        [SettingTable.Layers, SettingTable.SkippedLayers, SettingTable.Start, SettingTable.JoinTolerance, SettingTable.MaxError, SettingTable.Machine, SettingTable.Blank];

    public override bool StartsStep => false;

    public override bool IsMeasured => false; // One pass over the entities.

    public static IReadOnlyList<Diagnostic> FindingsOf(Drawing drawing, DrawingSettings settings) =>
        CutFindings.Find(drawing, StageOptions.SelectionOf(settings), settings.Start, settings.JoinToleranceMm, cutsHeights: settings.CuttingMachine.Height is not null);

    protected override CheckedJob Execute(CheckedJob job, CancellationToken cancellation) =>
        job with { Findings = [.. job.Findings, .. FindingsOf(job.Drawing, job.Settings), .. job.Cut.FindingsBeside(job.Sequence), .. OutsideBlank(job)] };

    private static IEnumerable<Diagnostic> OutsideBlank(CheckedJob job)
    {
        var (box, blank) = (FrameOutline.BoundsOf(job.Toolpath).Union(BeamOverscan.BoundsOf(job.Toolpath, job.Passes)), job.Settings.Placement.Blank);
        if (blank == default || box.IsEmpty) yield break;
        var outside = new[] { -box.MinX, -box.MinY, box.MaxX - blank.X, box.MaxY - blank.Y }.Max();
        if (outside > job.Settings.MaxErrorMm) yield return PlacementRules.OutsideBlank.At(default, FactText.Of(outside, 3));
    }
}
