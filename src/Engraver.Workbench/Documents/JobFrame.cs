using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Documents;

/// <summary>The frame of a job as a motion program.</summary>
public static class JobFrame
{
    /// <returns>Null if no part of the job can be cut.</returns>
    public static MotionProgram? Of(PreparedJob job, FrameShape shape)
    {
        ArgumentNullException.ThrowIfNull(job);
        if (job.Motion.Program is null) return null;
        var outline = shape == FrameShape.Hull ? FrameOutline.Hull(job.Toolpath) : FrameOutline.Rectangle(job.Toolpath);
        var program = MachineFamilies.DriverOf(job.Settings.CuttingMachine).Generate(outline, job.Settings.CuttingMachine, job.Settings.MotionTolerances, job.Drawing.SourceOf, MotionStyle.Continuous).Program;
        return program is { SegmentCount: > 0 } ? program : null;
    }
}
