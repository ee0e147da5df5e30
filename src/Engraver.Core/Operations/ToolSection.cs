using Engraver.Core.Diagnostics;

namespace Engraver.Core.Operations;

/// <summary>Consecutive strokes of a job that are cut with the same tool. Between two sections the tool is changed; operations keep their order, so a tool
/// may have several sections.</summary>
/// <param name="Tool">The tool of every stroke.</param>
/// <param name="FirstStroke">Index of its first stroke in the job.</param>
/// <param name="Operations">The operations of its strokes, in their order, at least one.</param>
/// <param name="Passes">Operation and pass of each of its strokes, at least one.</param>
public sealed record ToolSection(CuttingTool Tool, int FirstStroke, IReadOnlyList<Operation> Operations, IReadOnlyList<StrokePass> Passes)
{
    /// <summary>Number of strokes, at least 1.</summary>
    public int Strokes => Passes.Count;

    /// <summary>Index of the stroke after its last one.</summary>
    public int EndStroke => FirstStroke + Strokes;

    /// <summary>The sections of a job in their order. An operation without strokes needs no tool.</summary>
    /// <param name="plan">The tools of the operations.</param>
    /// <param name="passes">Operation and pass of each stroke of the job.</param>
    /// <returns>Empty for a job without strokes.</returns>
    public static IReadOnlyList<ToolSection> Of(OperationPlan plan, IReadOnlyList<StrokePass> passes)
    {
        ArgumentNullException.ThrowIfNull(plan);
        ArgumentNullException.ThrowIfNull(passes);
        var sections = new List<ToolSection>();
        for (var first = 0; first < passes.Count; first += sections[^1].Strokes)
        {
            var operation = passes[first].Operation;
            List<StrokePass> own = [.. passes.Skip(first).TakeWhile(pass => pass.Operation.Tool == operation.Tool)];
            sections.Add(new ToolSection(plan.ToolOf(operation), first, [.. own.Select(pass => pass.Operation).Distinct()], own));
        }

        return sections;
    }

    /// <summary>Why a program for one tool cannot have these sections; null for one section or none.</summary>
    public static Diagnostic? RefusalOfSeveral(IReadOnlyList<ToolSection> sections)
    {
        ArgumentNullException.ThrowIfNull(sections);
        return sections.Count < 2 ? null : OperationRules.SeveralTools.At(default, string.Join(", ", sections.Select(section => section.Tool.Title).Distinct()));
    }
}
