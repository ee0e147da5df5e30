using System.Globalization;

namespace Engraver.Benchmarks.Stages;

/// <summary>One row of the table in docs/benchmarks.md.</summary>
/// <param name="CpuSeconds">User and system time of the whole process, median of the repetitions.</param>
/// <param name="AllocatedBytes">Allocated on all threads, per entity.</param>
/// <param name="KeptBytes">Still reachable through the result, per entity.</param>
public sealed record StageFigure(int Entities, string Stage, double CpuSeconds, double AllocatedBytes, double KeptBytes, string Note)
{
    /// <summary>The two lines above the rows.</summary>
    public const string MarkdownHead = "| Entities | Stage | CPU s (median) | allocated bytes/entity | kept bytes/entity | note |\n|---:|---|---:|---:|---:|---|";

    public string ToMarkdown() => string.Create(
        CultureInfo.InvariantCulture, $"| {Entities} | {Stage} | {CpuSeconds:0.000} | {AllocatedBytes:0} | {KeptBytes:0} | {Note} |");
}
