using Engraver.Core.Kerf;
using Engraver.Core.Sequencing;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Replaces the contours by the path of the tool centre, if the settings request it.</summary>
internal sealed class KerfStage() : JobStage<AssignedJob, CompensatedJob>("Kerf", share: 0)
{
    public override IReadOnlyList<Setting> Settings =>
    [
        SettingTable.Kerf, SettingTable.ToolDiameter, SettingTable.JoinTolerance, SettingTable.MaxError, SettingTable.KeepDuplicates, SettingTable.RecoverArcs, SettingTable.Machine,
    ];

    public override bool StartsStep => false;

    public override bool IsMeasured => false; // The measured drawing is cut as drawn.

    protected override CompensatedJob Execute(AssignedJob job, CancellationToken cancellation)
    {
        var settings = job.Settings;
        if (settings.Kerf == KerfSide.Off || job.Assignment is not null) return new CompensatedJob(job, new CutTable(job.Analysed, null, []));
        var chained = Sequencer.Chain(job.Analysed, job.Drawing, StageOptions.SequencingFor(job.Drawing, settings));
        var options = new KerfOptions(settings.Kerf, settings.ToolDiameterMm, settings.MaxErrorMm, settings.JoinToleranceMm, settings.Machine.Height is not null);
        var kerf = KerfCompensation.Compensate(chained, options);
        return new CompensatedJob(job, new CutTable(kerf.Table, kerf, [.. chained.Diagnostics, .. kerf.Diagnostics]));
    }
}
