using Engraver.Core.Toolpaths;

namespace Engraver.Workbench.Stages;

/// <summary>A job with its machine-neutral path.</summary>
public record PathJob : OrderedJob
{
    public PathJob(OrderedJob job, Toolpath toolpath)
        : base(job) => Toolpath = toolpath;

    /// <summary>Ordered moves, millimetres.</summary>
    public Toolpath Toolpath { get; init; }
}
