using Engraver.Core.Operations;

namespace Engraver.Core.Posts;

/// <summary>The operations of a job that is written.</summary>
/// <param name="Plan">Their tools and speeds.</param>
/// <param name="Sections">The parts between two changes of the tool or stops, which cover every stroke; at least one.</param>
public sealed record PostOperations(OperationPlan Plan, IReadOnlyList<ToolSection> Sections)
{
    private readonly Operation[] _operations = [.. Sections.SelectMany(section => section.Passes).Select(pass => pass.Operation)];

    /// <summary>Operation and pass of each stroke, in the order of cutting.</summary>
    public IReadOnlyList<StrokePass> Passes => [.. Sections.SelectMany(section => section.Passes)];

    /// <summary>The operations, each once, in the order of cutting.</summary>
    public IEnumerable<Operation> All => _operations.Distinct();

    /// <summary>True when an operation states the speed of its spindle.</summary>
    public bool StateSpindle => All.Any(operation => Plan.SpindleOf(operation) is not null);

    /// <summary>The tool is changed between two sections.</summary>
    public bool ChangeTool => ToolSection.ChangesTool(Sections);

    /// <summary>The operation of a stroke.</summary>
    /// <param name="stroke">Index in the order of cutting.</param>
    public Operation OperationOf(int stroke) => _operations[stroke];

    /// <summary>Turns per minute at a stroke; null where its operation states none.</summary>
    public double? SpindleOf(int stroke) => Plan.SpindleOf(_operations[stroke]);

    /// <summary>The S word of a stroke: its power as a part of the full power, its turns per minute, or the usual value.</summary>
    /// <param name="usual">S word of full power, and of an operation that states neither.</param>
    public double SpeedOf(int stroke, double usual) => _operations[stroke].Power is { } percent ? usual * percent / 100.0 : SpindleOf(stroke) ?? usual;
}
