using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>Reports the progress of one job to two receivers.</summary>
internal sealed class ProgressPair(IProgress<JobProgress> first, IProgress<JobProgress> second) : IProgress<JobProgress>
{
    public void Report(JobProgress value)
    {
        first.Report(value);
        second.Report(value);
    }
}
