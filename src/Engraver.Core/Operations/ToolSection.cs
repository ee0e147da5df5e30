using Engraver.Core.Diagnostics;

namespace Engraver.Core.Operations;

/// <summary>Consecutive strokes of a job that are cut with the same tool and without a stop. Between two sections the tool is changed, or the machine stops
/// before a repeat; operations keep their order, so a tool may have several sections.</summary>
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

    /// <summary>The repeat of its first operation with which it begins, from 2: the machine stops before it, and the tool remains. Null for a section that
    /// begins with another tool, and for the first one.</summary>
    public int? Repeat { get; private init; }

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
            var end = first + 1;
            while (end < passes.Count && passes[end].Operation.Tool == passes[first].Operation.Tool && !passes[end].IsAfterStop(passes[end - 1])) end++;
            List<StrokePass> own = [.. Enumerable.Range(first, end - first).Select(stroke => passes[stroke])];
            var (operation, pass) = (own[0].Operation, own[0].Pass);
            sections.Add(new ToolSection(plan.ToolOf(operation), first, [.. own.Select(stroke => stroke.Operation).Distinct()], own) { Repeat = first > 0 && own[0].IsAfterStop(passes[first - 1]) ? operation.RepeatOf(pass) : null });
        }

        return sections;
    }

    /// <summary>True when the tool is changed between two sections of a job.</summary>
    public static bool ChangesTool(IReadOnlyList<ToolSection> sections)
    {
        ArgumentNullException.ThrowIfNull(sections);
        return sections.Skip(1).Any(section => section.Repeat is null);
    }

    /// <summary>Why one program that cannot stop cannot have these sections; null for one section or none.</summary>
    public static Diagnostic? RefusalOfSeveral(IReadOnlyList<ToolSection> sections)
    {
        ArgumentNullException.ThrowIfNull(sections);
        if (sections.Count < 2) return null;
        return ChangesTool(sections)
            ? OperationRules.SeveralTools.At(default, string.Join(", ", sections.Select(section => section.Tool.Title).Distinct()))
            : OperationRules.SeveralPrograms.At(default, sections[1].Operations[0].Title, FactText.Of(sections.Count));
    }
}
