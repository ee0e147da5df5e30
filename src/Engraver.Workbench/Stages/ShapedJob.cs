using Engraver.Core.Diagnostics;
using Engraver.Core.Operations;

namespace Engraver.Workbench.Stages;

/// <summary>A job with the path of the tool's centre of each operation.</summary>
public record ShapedJob : CompensatedJob
{
    public ShapedJob(CompensatedJob job, IReadOnlyList<ShapedOperation> shapes)
        : base(job) => Shapes = shapes;

    /// <summary>In the order of the operations; empty for a job without operations, or whose operations cannot be run.</summary>
    public IReadOnlyList<ShapedOperation> Shapes { get; init; }

    /// <summary>Why the operations cannot be run.</summary>
    public IReadOnlyList<Diagnostic> OperationFaults => [.. Assignment?.Faults ?? [], .. Shapes.SelectMany(shape => shape.Faults)];
}
