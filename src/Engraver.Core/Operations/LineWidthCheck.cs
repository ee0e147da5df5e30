using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Operations;

/// <summary>Compares the grooves of operations whose depth follows from the width of the lines with these widths, computed from the depth of every cut: shares
/// no method with <see cref="WidthDivision"/>. Whether every curve of a width is cut is checked by <see cref="OperationCheck"/>.</summary>
public static class LineWidthCheck
{
    /// <summary>Rounding of the width of a groove, mm.</summary>
    private const double Rounding = 1e-5;

    /// <param name="drawing">The drawing of the entity indices.</param>
    /// <param name="toolpath">The path of the whole job.</param>
    /// <param name="strokes">Operation and pass of each of its strokes.</param>
    public static IReadOnlyList<Diagnostic> Findings(OperationAssignment assignment, Drawing drawing, Toolpath toolpath, IReadOnlyList<StrokePass> strokes)
    {
        ArgumentNullException.ThrowIfNull(assignment);
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(toolpath);
        ArgumentNullException.ThrowIfNull(strokes);
        return assignment.ByWidth.Count == 0 ? [] : [.. assignment.ByWidth.SelectMany(one => Findings(one.Operation, [.. one.Entities], assignment, drawing, [.. toolpath.Strokes.Zip(strokes).Where(pair => pair.Second.Operation.DividedFrom == one.Operation.Id).SelectMany(pair => pair.First.Moves)]))];
    }

    private static IEnumerable<Diagnostic> Findings(Operation operation, HashSet<int> taken, OperationAssignment assignment, Drawing drawing, List<StrokeMove> moves)
    {
        var parts = assignment.Parts.Where(part => part.Operation.DividedFrom == operation.Id).ToList();
        var divided = parts.SelectMany(part => Enumerable.Range(0, part.Table.Count).Select(part.Table.EntityIndexOf)).ToHashSet();
        foreach (var entity in taken.Except(divided).Union(divided.Except(taken))) yield return NotAsStated(operation, drawing, entity, null);
        foreach (var cut in moves.GroupBy(move => move.EntityIndex))
        {
            var tool = parts[0].Tool;
            var slope = Math.Tan(tool.AngleDegrees.GetValueOrDefault() * Math.PI / 360.0);
            var lowest = cut.MinBy(move => Math.Min(move.StartZ, move.EndZ));
            var groove = tool.Tip + (2.0 * slope * (-Math.Min(lowest.StartZ, lowest.EndZ) - operation.StartDepth));
            if (!(Math.Abs(groove - WidthOf(drawing, cut.Key)) <= Rounding)) yield return NotAsStated(operation, drawing, cut.Key, lowest);
        }
    }

    /// <summary>The width that the drawing states for a curve, mm; NaN for none.</summary>
    private static double WidthOf(Drawing drawing, int entity)
    {
        var row = drawing.Entities[entity];
        var style = drawing.LineStyles[row.LineStyle];
        if (!style.Width.Equals(0.0)) return drawing.Scale.ToMillimetres(style.Width);
        int[] stated = [style.Lineweight, style.Lineweight == Lineweight.ByLayer ? drawing.Layers[row.Layer].Lineweight : Lineweight.Default, drawing.DefaultLineweight];
        return Array.Find(stated, weight => weight >= 0) * 0.01;
    }

    private static Diagnostic NotAsStated(Operation operation, Drawing drawing, int entity, StrokeMove? move)
    {
        var place = move?.Segment.Start ?? default;
        return OperationRules.NotAsStated.At(drawing.SourceOf(entity), operation.Title, Wording.Get("OperationCheck.width"), FactText.Of(place.X), FactText.Of(place.Y)) with { Place = place };
    }
}
