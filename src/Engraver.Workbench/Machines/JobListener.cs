using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines;

/// <summary>Hears a job's progress where the job tells it: at once and on the job's own thread.</summary>
internal sealed class JobListener(Action<JobProgress> hear) : IProgress<JobProgress>
{
    public void Report(JobProgress value) => hear(value);
}
