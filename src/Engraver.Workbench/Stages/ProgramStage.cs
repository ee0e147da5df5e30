using System.Collections.ObjectModel;
using Engraver.Core.Diagnostics;
using Engraver.Core.Posts;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Posts the program of the machine's own controller and arranges its motion in time.</summary>
internal sealed class ProgramStage() : JobStage<CheckedJob, PlannedJob>("Program", share: 20)
{
    public override IReadOnlyList<Setting> Settings => [];

    public override bool IsMeasured => false; // Measured with the verification of the posted program.

    protected override PlannedJob Execute(CheckedJob job, CancellationToken cancellation)
    {
        if (job.Motion.Program is not { SegmentCount: > 0 } program) return new PlannedJob(job);
        var driver = MachineFamilies.DriverOf(program.Profile);
        var post = PostTable.ForMotion(driver, program.Style)?.Post;
        var request = new PostRequest(job.Toolpath, program, job.Drawing.SourceOf, ReadOnlyDictionary<string, string>.Empty) { Machine = job.Settings.CuttingMachine, MaxErrorMm = job.Settings.MaxErrorMm };
        var refused = job.Passes.Count == 0 ? [] : driver.SupportOf(request.Machine).Refusals(job.Passes.Select(pass => pass.Operation));
        var posted = new Lazy<PostOutput?>(() => post?.Write(request));
        IReadOnlyList<Diagnostic> findings = refused.Count > 0 ? refused : post?.Findings(request) ?? [];
        cancellation.ThrowIfCancellationRequested();
        return new PlannedJob(job)
        {
            Posted = posted,
            Planned = PlannedMotion.Create(program, job.Toolpath, driver.NetworkTimes, post is null ? null : () => posted.Value!.SegmentLines, cancellation),
            PostFindings = findings,
        };
    }
}
