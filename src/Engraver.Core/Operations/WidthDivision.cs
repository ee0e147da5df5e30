using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Operations;

/// <summary>Divides an operation whose depth follows from the width of the lines into one operation for each width, the narrowest first.</summary>
/// <param name="drawing">The drawing of the entity indices.</param>
/// <param name="analysed">The rows that operations take.</param>
internal sealed class WidthDivision(Drawing drawing, OperationPlan plan, EntityTable analysed)
{
    /// <summary>Decimals of a width in millimetres; rounded to these, equal widths are equal.</summary>
    private const int Decimals = 6;

    private const int DepthDecimals = 9;

    private readonly List<Diagnostic> _faults = [];
    private readonly HashSet<string> _ids = [.. plan.Operations.Select(operation => operation.Id)];

    /// <summary>Widths that the tools cannot cut.</summary>
    public IReadOnlyList<Diagnostic> Faults => _faults;

    public IEnumerable<KeyValuePair<Operation, TakenContent>> Of(Operation operation, TakenContent taken)
    {
        foreach (var width in taken.Rows.GroupBy(row => Math.Round(drawing.LineWidthOf(analysed.EntityIndexOf(row)), Decimals)).OrderBy(group => group.Key))
        {
            if (FaultOf(operation, width.Key, [.. width]) is { } fault)
            {
                _faults.Add(fault);
                continue;
            }

            var content = new TakenContent();
            content.Rows.AddRange(width);
            yield return new(Divided(operation, width.Key), content);
        }
    }

    private Operation Divided(Operation operation, double width)
    {
        var text = NumberText.Rounded(width, Decimals);
        var id = $"{operation.Id}@{text}";
        while (!_ids.Add(id)) id += "'";
        return operation with
        {
            Id = id,
            Name = operation.Name.Length > 0 ? $"{operation.Name} {text} mm" : "",
            Depth = Math.Round(operation.StartDepth + plan.ToolOf(operation).DepthOf(width), DepthDecimals),
            DepthByWidth = false,
            DividedFrom = operation.Id,
        };
    }

    private Diagnostic? FaultOf(Operation operation, double width, List<int> rows)
    {
        var (tool, first) = (plan.ToolOf(operation), analysed.EntityIndexOf(rows[0]));
        var count = rows.Select(analysed.EntityIndexOf).Distinct().Count();
        var (source, place) = (drawing.SourceOf(first), analysed[rows[0]].StartPoint);
        if (double.IsNaN(width)) return OperationRules.WidthVaries.At(source, operation.Title, FactText.Of(count)) with { Place = place };
        if (width <= tool.Tip || width > tool.Diameter) return OperationRules.WidthNotCut.At(source, operation.Title, FactText.Of(width), FactText.Of(count), tool.Title, FactText.Of(tool.Tip), FactText.Of(tool.Diameter)) with { Place = place };
        var depth = tool.DepthOf(width);
        if (depth <= operation.Finish) return OperationRules.ValueInvalid.At(source, operation.Id + ": finish", FactText.Of(operation.Finish), Wording.Get("OperationFile.BelowDepth", FactText.Of(depth)));
        return operation.DepthPerPass is { } step && depth / step > OperationFile.MostPasses ? OperationRules.ValueInvalid.At(source, operation.Id + ": depthPerPass", FactText.Of(step), Wording.Get("OperationFile.TooManyPasses", OperationFile.MostPasses)) : null;
    }
}
