using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;

namespace Engraver.Core.Operations;

/// <summary>The rows of a drawing by operation.</summary>
public sealed record OperationAssignment
{
    /// <summary>The operations that are run, in their order.</summary>
    public required IReadOnlyList<OperationPart> Parts { get; init; }

    /// <summary>Entities that no operation takes, each once.</summary>
    public required IReadOnlyList<int> NotTaken { get; init; }

    /// <summary>The contours of every part that is profiled or cleared, also with another tool: leads keep away from them.</summary>
    public required IReadOnlyList<Segment> Contours { get; init; }

    /// <summary>Warnings and notes.</summary>
    public required IReadOnlyList<Diagnostic> Findings { get; init; }

    /// <summary>Why the operations cannot be run on this drawing or machine.</summary>
    public required IReadOnlyList<Diagnostic> Faults { get; init; }

    /// <param name="analysed">The rows of the layers that are cut.</param>
    /// <param name="drawing">The drawing of the entity indices.</param>
    /// <param name="tool">Number of the tool of the job: operations of other tools take their curves and are not run; 0: every tool.</param>
    public static OperationAssignment Of(EntityTable analysed, Drawing drawing, OperationPlan plan, MachineProfile machine, MachineLimits limits, int tool)
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

        IReadOnlyList<Segment> contours = [.. rows.Where(entry => entry.Key.Kind is OperationKind.Profile or OperationKind.Pocket).SelectMany(entry => entry.Value).Distinct().Order().Select(row => analysed[row].ToSegment())];
        foreach (var other in rows.Keys.Except(plan.Active(tool)).ToList()) rows.Remove(other);
        return new OperationAssignment
        {
            Parts = [.. rows.Select(entry => new OperationPart(entry.Key, plan.ToolOf(entry.Key), analysed.Picking([.. entry.Value])))],
            NotTaken = [.. notTaken.Keys],
            Contours = contours,
            Findings = [.. FindingsOf(rows, plan), .. notTaken.Count == 0 ? [] : (Diagnostic[])[OperationRules.NotTaken.At(drawing.SourceOf(notTaken.Keys.First()), FactText.Of(notTaken.Count), FactText.Of(notTaken.Values.Sum()))]],
            Faults = [.. FaultsOf(drawing, plan, machine, limits, tool)],
        };
    }

    private static IEnumerable<Diagnostic> FindingsOf(Dictionary<Operation, List<int>> rows, OperationPlan plan)
    {
        foreach (var (operation, taken) in rows)
        {
            if (taken.Count == 0) yield return OperationRules.TakesNothing.At(default, operation.Title);
            if (plan.SpindleOf(operation) is { } speed) yield return OperationRules.SpindleByHand.At(default, operation.Title, FactText.Of(speed));
        }

        var active = rows.Keys.ToList();
        foreach (var (one, other) in active.SelectMany((one, index) => active.Skip(index + 1).Where(other => (other.Kind, other.Tool, other.Depth) == (one.Kind, one.Tool, one.Depth)).Select(other => (one, other))))
        {
            if (rows[one].Intersect(rows[other]).Count() is > 0 and var count) yield return OperationRules.CutTwice.At(default, one.Title, other.Title, FactText.Of(count));
        }
    }

    private static IEnumerable<Diagnostic> FaultsOf(Drawing drawing, OperationPlan plan, MachineProfile machine, MachineLimits limits, int tool)
    {
        // Also those that are off or of another tool: what they name is not the rest.
        foreach (var operation in plan.Operations)
        {
            foreach (var layer in operation.Select.UnknownLayers(drawing)) yield return OperationRules.LayerUnknown.At(default, operation.Title, layer, JsonFields.Nearest(layer, [.. drawing.Layers.Select(known => known.Name)]));
            foreach (var handle in operation.Select.UnknownHandles(drawing)) yield return OperationRules.HandleUnknown.At(default, operation.Title, handle);
        }

        var active = plan.Active(tool).ToList();
        foreach (var operation in active)
        {
            foreach (var fault in LimitFaultsOf(operation, plan, machine, limits)) yield return fault;
            if (machine.Height is null && operation.Kind == OperationKind.Drill) yield return OperationRules.NoToolAxis.At(default, operation.Title, "drill");
            else if (machine.Height is null && operation.Depth is not null) yield return OperationRules.NoToolAxis.At(default, operation.Title, "depth");
            if (machine.Height is not null && operation.Depth is null) yield return OperationRules.NoDepth.At(default, operation.Title);
        }

        if (active.Count == 0) yield return OperationRules.NothingOn.At(default, tool == 0 ? "*" : FactText.Of(tool));
    }

    /// <summary>Speeds and depths that the machine cannot count, and depths that the tool does not reach.</summary>
    private static IEnumerable<Diagnostic> LimitFaultsOf(Operation operation, OperationPlan plan, MachineProfile machine, MachineLimits limits)
    {
        var feed = plan.FeedOf(operation, machine);
        if (!MachineProfileValidation.IsFeed(feed, machine, limits)) yield return OperationRules.ValueInvalid.At(default, operation.Id + ": feed", FactText.Of(feed), MachineProfileValidation.FeedRange(machine, limits));
        if (plan.PlungeOf(operation, machine) is { } plunge && !MachineProfileValidation.IsSpeed(machine.Scale.Z.CountsOf(plunge / 60.0), limits)) yield return OperationRules.ValueInvalid.At(default, operation.Id + ": plunge", FactText.Of(plunge), MachineProfileValidation.AxisSpeeds(limits));
        if (operation.Depth is not { } depth) yield break;
        if (plan.ToolOf(operation) is { MaxDepth: { } limit } tool && depth > limit) yield return OperationRules.DeeperThanTool.At(default, operation.Title, FactText.Of(depth), tool.Title, FactText.Of(limit));
        if (machine.Height is null) yield break;
        var depths = operation.PassDepths().Prepend(operation.StartDepth).Distinct().ToList();
        if (depths.Zip(depths.Skip(1)).Any(step => machine.Scale.ToHeight(-step.First) == machine.Scale.ToHeight(-step.Second))) yield return OperationRules.ValueInvalid.At(default, operation.Id + ": depth", FactText.Of(depth), Wording.Get("OperationFile.OneCount", FactText.Of(machine.Scale.Z.LengthOf(1.0))));
    }
}
