using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Machines;

namespace Engraver.Core.Operations;

/// <summary>The rows of a drawing by operation.</summary>
public sealed record OperationAssignment
{
    /// <summary>The operations that are run, in their order.</summary>
    public required IReadOnlyList<OperationPart> Parts { get; init; }

    /// <summary>Entities that no operation takes, each once.</summary>
    public required IReadOnlyList<int> NotTaken { get; init; }

    /// <summary>Warnings and notes.</summary>
    public required IReadOnlyList<Diagnostic> Findings { get; init; }

    /// <summary>Why the operations cannot be run on this drawing or machine.</summary>
    public required IReadOnlyList<Diagnostic> Faults { get; init; }

    /// <param name="analysed">The rows of the layers that are cut.</param>
    /// <param name="drawing">The drawing of the entity indices.</param>
    /// <param name="tool">Number of the tool of the job: operations of other tools take their curves and are not run; 0: every tool.</param>
    public static OperationAssignment Of(EntityTable analysed, Drawing drawing, OperationPlan plan, MachineProfile machine, int tool)
    {
        ArgumentNullException.ThrowIfNull(analysed);
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(plan);
        var named = plan.Operations.Select(operation => (Operation: operation, Takes: operation.Select.NamedIn(drawing))).ToList();
        var rows = plan.Active(0).ToDictionary(operation => operation, _ => new List<int>());
        var notTaken = new SortedDictionary<int, double>();
        for (var row = 0; row < analysed.Count; row++)
        {
            var entity = analysed.EntityIndexOf(row);
            var isNamed = named.Any(one => one.Takes(entity));
            var isTaken = false;
            foreach (var (operation, takes) in named)
            {
                if (!operation.IsOn || !(operation.Select.IsRest ? !isNamed : takes(entity))) continue;
                rows[operation].Add(row);
                isTaken = true;
            }

            if (!isTaken) notTaken[entity] = notTaken.GetValueOrDefault(entity) + analysed[row].ToSegment().Length;
        }

        foreach (var other in rows.Keys.Except(plan.Active(tool)).ToList()) rows.Remove(other);
        return new OperationAssignment
        {
            Parts = [.. rows.Select(entry => new OperationPart(entry.Key, plan.ToolOf(entry.Key), analysed.Picking([.. entry.Value])))],
            NotTaken = [.. notTaken.Keys],
            Findings = [.. FindingsOf(rows, plan, machine), .. notTaken.Count == 0 ? [] : (Diagnostic[])[OperationRules.NotTaken.At(drawing.SourceOf(notTaken.Keys.First()), FactText.Of(notTaken.Count), FactText.Of(notTaken.Values.Sum()))]],
            Faults = [.. FaultsOf(drawing, plan, machine, tool)],
        };
    }

    private static IEnumerable<Diagnostic> FindingsOf(Dictionary<Operation, List<int>> rows, OperationPlan plan, MachineProfile machine)
    {
        foreach (var (operation, taken) in rows)
        {
            if (taken.Count == 0) yield return OperationRules.TakesNothing.At(default, operation.Title);
            if (plan.ToolOf(operation) is { MaxDepth: { } limit } tool && operation.Depth is { } depth && depth > limit) yield return OperationRules.DeeperThanTool.At(default, operation.Title, FactText.Of(depth), tool.Title, FactText.Of(limit));
            if (plan.SpindleOf(operation) is { } speed) yield return OperationRules.SpindleByHand.At(default, operation.Title, FactText.Of(speed));
        }

        var active = rows.Keys.ToList();
        foreach (var (one, other) in active.SelectMany((one, index) => active.Skip(index + 1).Where(other => (other.Kind, other.Tool, other.Depth) == (one.Kind, one.Tool, one.Depth)).Select(other => (one, other))))
        {
            if (rows[one].Intersect(rows[other]).Count() is > 0 and var count) yield return OperationRules.CutTwice.At(default, one.Title, other.Title, FactText.Of(count));
        }

        if (active.Select(operation => plan.PlungeOf(operation, machine)).OfType<double>().Distinct().ToList() is { Count: > 1 } plunges) yield return OperationRules.LowestPlunge.At(default, FactText.Of(plunges.Min()));
    }

    private static IEnumerable<Diagnostic> FaultsOf(Drawing drawing, OperationPlan plan, MachineProfile machine, int tool)
    {
        var active = plan.Active(tool).ToList();
        foreach (var operation in active)
        {
            foreach (var layer in operation.Select.UnknownLayers(drawing)) yield return OperationRules.LayerUnknown.At(default, operation.Title, layer, JsonFields.Nearest(layer, [.. drawing.Layers.Select(known => known.Name)]));
            foreach (var handle in operation.Select.UnknownHandles(drawing)) yield return OperationRules.HandleUnknown.At(default, operation.Title, handle);
            if (machine.Height is null && operation.Kind == OperationKind.Drill) yield return OperationRules.NoToolAxis.At(default, operation.Title, "drill");
            else if (machine.Height is null && operation.Depth is not null) yield return OperationRules.NoToolAxis.At(default, operation.Title, "depth");
            if (machine.Height is not null && operation.Depth is null) yield return OperationRules.NoDepth.At(default, operation.Title);
        }

        if (active.Count == 0) yield return OperationRules.NothingOn.At(default, tool == 0 ? "" : FactText.Of(tool));
        if (active.Select(operation => operation.Tool).Distinct().Order().ToList() is { Count: > 1 } tools) yield return OperationRules.SeveralTools.At(default, string.Join(", ", tools.Select(tool => plan.Tools.First(one => one.Number == tool).Title)));
    }
}
