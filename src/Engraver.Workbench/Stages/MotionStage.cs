using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>Generates the motion program by the driver of the machine.</summary>
internal sealed class MotionStage() : JobStage<PathJob, MotionJob>("Motion", share: 15)
{
    public override IReadOnlyList<Setting> Settings =>
        [SettingTable.MaxError, SettingTable.CornerTolerance, SettingTable.FitArcs, SettingTable.Finish, SettingTable.Machine, SettingTable.Feed, SettingTable.VectorSpeed, SettingTable.Rapid, SettingTable.Acceleration];

    protected override MotionJob Execute(PathJob job, CancellationToken cancellation)
    {
        var motion = MachineFamilies.DriverOf(job.Settings.CuttingMachine).Generate(job.Toolpath, job.Settings.CuttingMachine, job.Settings.MotionTolerances, job.Drawing.SourceOf, job.Style);
        return new MotionJob(job, motion.Program is { } program ? motion with { Program = program with { Finish = FinishOf(program, job.Settings) } } : motion);
    }

    protected override string SizeOf(MotionJob job) => Wording.Get("Stage.Motion.Figure", job.Motion.Program?.SegmentCount ?? 0);

    /// <summary>Null for the park position, which is a machine position and known only after the job is placed.</summary>
    private static CountsPoint? FinishOf(MotionProgram program, DrawingSettings settings) => settings.Finish == FinishPlace.Origin ? program.Start : null;
}
