using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.Stages;

/// <summary>A job whose toolpath has been compared with the drawing. With faults it has no program.</summary>
public record CheckedJob : MotionJob
{
    public CheckedJob(MotionJob job, IReadOnlyList<Diagnostic> faults)
        : base(job) => Faults = faults;

    /// <summary>Where the toolpath differs from the drawing (VER0020 to VER0022), letters that are not at their places (VER0023), and fields without a
    /// value.</summary>
    public IReadOnlyList<Diagnostic> Faults { get; init; }
}
