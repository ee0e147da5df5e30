using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>Two who look at the same job.</summary>
internal sealed class Both(IProgress<JobProgress> first, IProgress<JobProgress> second) : IProgress<JobProgress>
{
    public void Report(JobProgress value)
    {
        first.Report(value);
        second.Report(value);
    }
}
