using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines;

/// <summary>Forwards the progress of a job synchronously on the thread of the job.</summary>
internal sealed class JobListener(Action<JobProgress> hear) : IProgress<JobProgress>
{
    public void Report(JobProgress value) => hear(value);
}
