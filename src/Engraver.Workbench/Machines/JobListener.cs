using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines;

/// <summary>Passes a job's progress on at once, on the job's own thread.</summary>
internal sealed class JobListener(Action<JobProgress> hear) : IProgress<JobProgress>
{
    public void Report(JobProgress value) => hear(value);
}
