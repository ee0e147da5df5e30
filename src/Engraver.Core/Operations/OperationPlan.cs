using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Operations;

/// <summary>The operations of a job in their order, and the tools that they name. Immutable; two plans are equal when their texts are.</summary>
public sealed class OperationPlan : IEquatable<OperationPlan>
{
    private const int MostOutputs = 8;
    private readonly string _text;

    /// <param name="operations">Ids are unique; every tool is in <paramref name="tools"/>.</param>
    internal OperationPlan(IReadOnlyList<Operation> operations, IReadOnlyList<CuttingTool> tools)
    {
        (Operations, Tools) = (operations, tools);
        _text = OperationText.Write(this, withAllTools: false);
    }

    public IReadOnlyList<Operation> Operations { get; }

    /// <summary>The tools of the library, with the feeds of the chosen material.</summary>
    public IReadOnlyList<CuttingTool> Tools { get; }

    /// <summary>Construction whose outlines a drawing must have for these operations.</summary>
    public CutChoice Areas => Operations.Any(operation => operation.TakesHatches) ? CutChoice.Hatch | CutChoice.Solid : CutChoice.None;

    /// <summary>The operations that are run.</summary>
    /// <param name="tool">Number of the tool of the job; 0: every tool.</param>
    public IEnumerable<Operation> Active(int tool) => Operations.Where(operation => operation.IsOn && (tool == 0 || operation.Tool == tool));

    public CuttingTool ToolOf(Operation operation) => Tools.First(tool => tool.Number == operation.Tool);

    /// <summary>Cutting speed of an operation on a machine, mm/min.</summary>
    public double FeedOf(Operation operation, MachineProfile machine) => operation.Feed ?? ToolOf(operation).Feed ?? machine.FeedMmPerMinute;

    /// <summary>Speed straight down, mm/min; null on a machine without a tool axis.</summary>
    public double? PlungeOf(Operation operation, MachineProfile machine) => machine.Height is { } drive ? operation.Plunge ?? ToolOf(operation).Plunge ?? drive.PlungeMmPerMinute : null;

    /// <summary>Turns per minute; null where neither operation nor tool states it, and for a beam whose power the operation states.</summary>
    public double? SpindleOf(Operation operation) => operation.Power is null ? operation.Spindle ?? ToolOf(operation).Spindle : null;

    /// <summary>Outputs of a machine that are on while an operation is cut, bit 0 is output 1; a name that the profile does not have is left out.</summary>
    public static int OutputsOf(Operation operation, MachineProfile machine)
    {
        ArgumentNullException.ThrowIfNull(operation);
        ArgumentNullException.ThrowIfNull(machine);
        return operation.Outputs.Select(name => machine.Outputs.Find(name, MostOutputs)).OfType<int>().Aggregate(0, (word, output) => word | (1 << (output - 1)));
    }

    /// <summary>Power of the beam or speed of the spindle as a part of the full value of the machine's analog output; null where it has none or no operation of
    /// the job states a speed.</summary>
    /// <param name="tool">As for <see cref="Active"/>.</param>
    public double? AnalogPartOf(Operation operation, MachineProfile machine, int tool)
    {
        ArgumentNullException.ThrowIfNull(operation);
        ArgumentNullException.ThrowIfNull(machine);
        if (machine.Power is not null) return operation.Power / 100.0;
        if (machine.Spindle is not { SpeedAxis: not null, FullSpeed: { } full } || Active(tool).All(one => SpindleOf(one) is null)) return null;
        return (SpindleOf(operation) ?? full) / full;
    }

    /// <summary>The machine of a job with these operations, which replace the cutting depth, the depth of a pass and the plunge feed of its
    /// profile; its feeds are the highest of the operations, of which each stroke has its own. It switches their outputs. Applied to
    /// its own result, it changes nothing.</summary>
    /// <param name="tool">As for <see cref="Active"/>.</param>
    public MachineProfile Applied(MachineProfile machine, int tool)
    {
        ArgumentNullException.ThrowIfNull(machine);
        machine = machine with { OperationOutputs = Active(tool).Aggregate(0, (word, operation) => word | OutputsOf(operation, machine)) };
        machine = machine with { FeedMmPerMinute = Active(tool).Select(operation => FeedOf(operation, machine)).DefaultIfEmpty(machine.FeedMmPerMinute).Max() };
        if (machine.Height is not { } drive) return machine;
        var plunge = Active(tool).Select(operation => PlungeOf(operation, machine)!.Value).DefaultIfEmpty(drive.PlungeMmPerMinute).Max();
        return machine with { Height = drive with { CutDepth = 0.0, DepthPerPass = null, PlungeMmPerMinute = plunge } };
    }

    /// <summary>The plan with the handles that the entities of its selections have in another file.</summary>
    /// <param name="written">The handles of an entity there; none for an entity that is not in it.</param>
    public OperationPlan WithHandles(Func<string, IReadOnlyList<string>> written)
    {
        ArgumentNullException.ThrowIfNull(written);
        return Operations.All(operation => operation.Select.Handles.Count == 0) ? this : new OperationPlan([.. Operations.Select(operation => operation with { Select = operation.Select.WithHandles(written) })], Tools);
    }

    /// <summary>The plan with its picked places, which are on the drawing of the file, on the placed drawing.</summary>
    public OperationPlan PlacedOn(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return drawing.PlacementMap == Transform2D.Identity ? this : new OperationPlan([.. Operations.Select(operation => operation.Placed(drawing.Placed))], Tools);
    }

    public bool Equals(OperationPlan? other) => other is not null && other._text == _text;

    public override bool Equals(object? obj) => Equals(obj as OperationPlan);

    public override int GetHashCode() => _text.GetHashCode(StringComparison.Ordinal);

    /// <summary>The plan as the text of an operations file, with every tool.</summary>
    public string ToFileText() => OperationText.Write(this, withAllTools: true);

    /// <summary>The plan as the text of an operations file, with the tools that its operations name.</summary>
    public override string ToString() => _text;
}
