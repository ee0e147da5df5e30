using Engraver.Core.Machines;

namespace Engraver.Workbench.Stages;

/// <summary>A job with the motion program of its machine.</summary>
public record MotionJob : PathJob
{
    public MotionJob(PathJob job, MotionGeneration motion)
        : base(job) => Motion = motion;

    /// <summary>The program in counts, or the reason why there is none.</summary>
    public MotionGeneration Motion { get; init; }
}
