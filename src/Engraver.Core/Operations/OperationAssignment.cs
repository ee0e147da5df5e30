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

    /// <summary>The operations of the plan whose depth follows from the width of the lines, with the entities that they take. <see cref="Parts"/> has one
    /// operation for each width instead.</summary>
    public IReadOnlyList<(Operation Operation, IReadOnlyList<int> Entities)> ByWidth { get; private init; } = [];

    /// <summary>Entities that no operation takes, each once.</summary>
    public required IReadOnlyList<int> NotTaken { get; init; }

    /// <summary>The drawing, with an entity for each place that is drilled; points and hatches that operations take are no longer among what is not
    /// cut.</summary>
    public required Drawing Drawing { get; init; }

    /// <summary>The contours of every part that is profiled or cleared, also with another tool: leads keep away from them.</summary>
    public required IReadOnlyList<Segment> Contours { get; init; }

    /// <summary>Warnings and notes.</summary>
    public required IReadOnlyList<Diagnostic> Findings { get; init; }

    /// <summary>Why the operations cannot be run on this drawing or machine.</summary>
    public required IReadOnlyList<Diagnostic> Faults { get; init; }

    /// <param name="analysed">The rows of the layers that are cut.</param>
    /// <param name="drawing">The drawing of the entity indices.</param>
    /// <param name="tool">Number of the tool of the job: operations of other tools take their curves and are not run; 0: every tool.</param>
    /// <param name="layers">The layers that are cut, for points and inserts.</param>
    /// <param name="reserved">Number of entities of the document: those that are added for places are behind them.</param>
    public static OperationAssignment Of(EntityTable analysed, Drawing drawing, OperationPlan plan, MachineProfile machine, MachineLimits limits, int tool, LayerSelection layers, int reserved = 0)
    {
        ArgumentNullException.ThrowIfNull(layers);
        ArgumentNullException.ThrowIfNull(analysed);
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(plan);
        var named = plan.Operations.Select(operation => (Operation: operation, Names: operation.Select.In(drawing))).ToList();
        var taken = plan.Active(0).ToDictionary(operation => operation, _ => new TakenContent());
        var notTaken = new SortedDictionary<int, double>();
        for (var row = 0; row < analysed.Count; row++)
        {
            var entity = analysed.EntityIndexOf(row);
            var isNamed = named.Any(one => one.Names.Has(entity));
            var isTaken = false;
            foreach (var (operation, names) in named)
            {
                if (!operation.IsOn || !(operation.Select.IsRest ? !isNamed : names.Has(entity))) continue;
                if (operation.TakesHatches)
                {
                    isTaken |= drawing.Entities[entity].Type is CurveType.Hatch or CurveType.Solid or CurveType.Trace; // its areas are taken below
                    continue;
                }

                taken[operation].Rows.Add(row);
                if (operation.Kind == OperationKind.Drill && names.IsOfBlock(entity)) taken[operation].RowsOfBlocks.Add(row);
                isTaken = true;
            }

            if (!isTaken) notTaken[entity] = notTaken.GetValueOrDefault(entity) + analysed[row].ToSegment().Length;
        }

        var areas = plan.Areas == CutChoice.None ? new EntityTable() : ArcAnalysis.Analyse(EntityTableBuilder.BuildAreas(drawing, layers));
        for (var row = 0; row < areas.Count; row++)
        {
            var entity = areas.EntityIndexOf(row);
            var isNamed = named.Any(one => one.Names.Has(entity));
            foreach (var (operation, names) in named.Where(one => one.Operation is { IsOn: true, TakesHatches: true }))
            {
                if (operation.Select.IsRest ? !isNamed : names.Has(entity)) taken[operation].Areas.Add(row);
            }
        }

        var placed = new PlacedContent(drawing, analysed, layers.Taken(drawing.Layers), reserved);
        TakePlaces(named, taken, placed, drawing);
        IReadOnlyList<Segment> contours = [.. taken.Where(entry => entry.Key.Kind is OperationKind.Profile or OperationKind.Pocket).SelectMany(entry => entry.Value.Rows).Distinct().Order().Select(row => analysed[row].ToSegment()), .. taken.Where(entry => entry.Key.Kind == OperationKind.Pocket).SelectMany(entry => entry.Value.Areas).Distinct().Order().Select(row => areas[row].ToSegment())];
        var drilled = taken.Values.SelectMany(one => one.Points.Concat(one.PointsOfBlocks)).Distinct().ToList();
        var filled = taken.Values.SelectMany(one => one.Areas).Select(areas.EntityIndexOf).Distinct().ToList();
        foreach (var other in taken.Keys.Except(plan.Active(tool)).ToList()) taken.Remove(other);
        var division = new WidthDivision(drawing, plan, analysed);
        var divided = taken.SelectMany(entry => entry.Key.DepthByWidth && machine.Height is not null ? division.Of(entry.Key, entry.Value) : [entry]).ToDictionary();
        return new OperationAssignment
        {
            ByWidth = [.. taken.Where(entry => entry.Key.DepthByWidth).Select(entry => (entry.Key, (IReadOnlyList<int>)[.. entry.Value.Rows.Select(analysed.EntityIndexOf).Distinct()]))],
            Parts =
            [
                .. divided.Select(entry => new OperationPart(entry.Key, plan.ToolOf(entry.Key), entry.Key.TakesHatches ? areas.Picking([.. entry.Value.Areas]) : analysed.Picking([.. entry.Value.Rows.Where(row => !entry.Value.RowsOfBlocks.Contains(row))]))
                {
                    Places = [.. entry.Value.Points.Select(placed.AtPoint), .. entry.Value.Inserts.Select(placed.AtInsert)],
                }),
            ],
            Drawing = placed.ToDrawing(drilled, filled),
            NotTaken = [.. notTaken.Keys],
            Contours = contours,
            Findings = [.. FindingsOf(taken, divided, plan, machine), .. notTaken.Count == 0 ? [] : (Diagnostic[])[OperationRules.NotTaken.At(drawing.SourceOf(notTaken.Keys.First()), FactText.Of(notTaken.Count), FactText.Of(notTaken.Values.Sum()))]],
            Faults = [.. FaultsOf(drawing, plan, machine, limits, tool), .. division.Faults, .. divided.Keys.SelectMany(operation => DepthFaultsOf(operation, plan, machine))],
        };
    }

    /// <summary>The points and insertion points of the drills. Other operations do not take points.</summary>
    private static void TakePlaces(List<(Operation Operation, SelectedContent Names)> named, Dictionary<Operation, TakenContent> taken, PlacedContent placed, Drawing drawing)
    {
        if (!named.Exists(one => one.Operation is { IsOn: true, Kind: OperationKind.Drill })) return;
        foreach (var index in placed.Points)
        {
            var point = drawing.Points[index];
            var isNamed = named.Exists(one => one.Names.Has(point));
            foreach (var (operation, names) in named.Where(one => one.Operation is { IsOn: true, Kind: OperationKind.Drill }))
            {
                if (operation.Select.IsRest ? isNamed : !names.Has(point)) continue;
                (names.IsOfBlock(point) ? taken[operation].PointsOfBlocks : taken[operation].Points).Add(index);
            }
        }

        foreach (var index in placed.Inserts)
        {
            foreach (var (operation, names) in named.Where(one => one.Operation is { IsOn: true, Kind: OperationKind.Drill }))
            {
                if (names.Has(drawing.Inserts[index])) taken[operation].Inserts.Add(index);
            }
        }
    }

    private static IEnumerable<Diagnostic> FindingsOf(Dictionary<Operation, TakenContent> stated, Dictionary<Operation, TakenContent> content, OperationPlan plan, MachineProfile machine)
    {
        foreach (var (operation, taken) in stated)
        {
            if (taken.IsEmpty) yield return OperationRules.TakesNothing.At(default, operation.Title);
            if (plan.SpindleOf(operation) is { } speed && machine.Spindle is not { SpeedAxis: not null, FullSpeed: not null }) yield return OperationRules.SpindleByHand.At(default, operation.Title, FactText.Of(speed));
        }

        var active = content.Keys.ToList();
        foreach (var (one, other) in active.SelectMany((one, index) => active.Skip(index + 1).Where(other => (other.Kind, other.Tool, other.Depth) == (one.Kind, one.Tool, one.Depth)).Select(other => (one, other))))
        {
            if (content[one].SharedWith(content[other]) is > 0 and var count) yield return OperationRules.CutTwice.At(default, one.Title, other.Title, FactText.Of(count));
        }
    }

    private static IEnumerable<Diagnostic> FaultsOf(Drawing drawing, OperationPlan plan, MachineProfile machine, MachineLimits limits, int tool)
    {
        // Also those that are off or of another tool: what they name is not the rest.
        foreach (var operation in plan.Operations)
        {
            foreach (var layer in operation.Select.UnknownLayers(drawing)) yield return OperationRules.LayerUnknown.At(default, operation.Title, layer, JsonFields.Nearest(layer, [.. drawing.Layers.Select(known => known.Name)]));
            foreach (var linetype in operation.Select.UnknownLinetypes(drawing)) yield return OperationRules.LinetypeUnknown.At(default, operation.Title, linetype, JsonFields.Nearest(linetype, OperationSelection.LinetypesOf(drawing)));
            foreach (var block in operation.Select.UnknownBlocks(drawing)) yield return OperationRules.BlockUnknown.At(default, operation.Title, block, JsonFields.Nearest(block, OperationSelection.BlocksOf(drawing)));
            if (operation is { IsOn: true, TakesHatches: true } && !drawing.IsNew && !(drawing.Cut | drawing.Areas).HasFlag(CutChoice.Hatch | CutChoice.Solid)) yield return OperationRules.HatchesNotRead.At(default, operation.Title);
            if (operation.Kind == OperationKind.Drill && operation.Select.Blocks.Count > 0 && !drawing.HasAllInserts) yield return OperationRules.InsertsLeftOut.At(default, operation.Title);
            foreach (var handle in operation.Select.UnknownHandles(drawing)) yield return OperationRules.HandleUnknown.At(default, operation.Title, handle);
        }

        var active = plan.Active(tool).ToList();
        foreach (var operation in active)
        {
            foreach (var fault in SpeedFaultsOf(operation, plan, machine, limits)) yield return fault;
            if (machine.Height is null && operation.Kind == OperationKind.Drill) yield return OperationRules.NoToolAxis.At(default, operation.Title, "drill");
            else if (machine.Height is null && (operation.DepthByWidth || operation.Depth is not null)) yield return OperationRules.NoToolAxis.At(default, operation.Title, "depth");
            if (machine.Height is not null && operation.Power is not null) yield return OperationRules.BeamOnAxis.At(default, operation.Title, "power");
            else if (machine.Height is not null && operation.Overscan > 0.0) yield return OperationRules.BeamOnAxis.At(default, operation.Title, "overscan");
            else if (machine.Height is not null && operation is { Depth: null, DepthByWidth: false }) yield return OperationRules.NoDepth.At(default, operation.Title);
        }

        if (active.Count == 0) yield return OperationRules.NothingOn.At(default, tool == 0 ? "*" : FactText.Of(tool));
    }

    /// <summary>Speeds that the machine cannot count.</summary>
    private static IEnumerable<Diagnostic> SpeedFaultsOf(Operation operation, OperationPlan plan, MachineProfile machine, MachineLimits limits)
    {
        var feed = plan.FeedOf(operation, machine);
        if (!MachineProfileValidation.IsFeed(feed, machine, limits)) yield return OperationRules.ValueInvalid.At(default, operation.Id + ": feed", FactText.Of(feed), MachineProfileValidation.FeedRange(machine, limits));
        if (plan.PlungeOf(operation, machine) is { } plunge && !MachineProfileValidation.IsSpeed(machine.Scale.Z.CountsOf(plunge / 60.0), limits)) yield return OperationRules.ValueInvalid.At(default, operation.Id + ": plunge", FactText.Of(plunge), MachineProfileValidation.AxisSpeeds(limits));
        foreach (var name in operation.Outputs)
        {
            if (machine.Outputs.Find(name, limits.Outputs) is not { } output) yield return OperationRules.ValueInvalid.At(default, operation.Id + ": outputs", name, machine.Outputs.All.Count == 0 ? Wording.Get("OperationAssignment.NoOutputs") : string.Join(", ", machine.Outputs.All.Values));
            else if (machine.IsToolOrSpindle(output)) yield return OperationRules.ValueInvalid.At(default, operation.Id + ": outputs", name, Wording.Get("OperationAssignment.NotTheTool"));
        }

        if (machine.Spindle is { SpeedAxis: not null, FullSpeed: { } full } && plan.SpindleOf(operation) is { } speed && speed > full) yield return OperationRules.ValueInvalid.At(default, operation.Id + ": spindle", FactText.Of(speed), Wording.Get("OperationFile.NumberAbove", 0.0, full));
    }

    /// <summary>Depths that the machine cannot count, and those that the tool does not reach.</summary>
    private static IEnumerable<Diagnostic> DepthFaultsOf(Operation operation, OperationPlan plan, MachineProfile machine)
    {
        if (operation.Depth is not { } depth) yield break;
        if (plan.ToolOf(operation) is { MaxDepth: { } limit } tool && depth > limit) yield return OperationRules.DeeperThanTool.At(default, operation.Title, FactText.Of(depth), tool.Title, FactText.Of(limit));
        if (machine.Height is null) yield break;
        var depths = operation.PassDepths().Prepend(operation.StartDepth).Distinct().ToList();
        if (depths.Zip(depths.Skip(1)).Any(step => machine.Scale.ToHeight(-step.First) == machine.Scale.ToHeight(-step.Second))) yield return OperationRules.ValueInvalid.At(default, operation.Id + ": depth", FactText.Of(depth), Wording.Get("OperationFile.OneCount", FactText.Of(machine.Scale.Z.LengthOf(1.0))));
    }
}
