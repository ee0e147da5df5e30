using Engraver.Core.Operations;

namespace Engraver.Workbench.Stages;

/// <summary>A job whose rows are divided among its operations.</summary>
public record AssignedJob : AnalysedJob
{
    public AssignedJob(AnalysedJob job, OperationAssignment? assignment)
        : base(job) => Assignment = assignment;

    /// <summary>What each operation takes; null for a job without operations.</summary>
    public OperationAssignment? Assignment { get; init; }
}
