using Engraver.Core.Machines;
using Engraver.Core.Operations;

namespace Engraver.Workbench.Documents;

/// <summary>A part of a job between two changes of the tool or stops, by the segments of its motion program.</summary>
/// <param name="Tool">Its tool, operations and strokes.</param>
/// <param name="Number">From 1.</param>
/// <param name="Count">Number of sections of the job, at least 2.</param>
/// <param name="From">Segments of the program before it.</param>
/// <param name="Until">Segments of the program up to its end.</param>
public sealed record JobSection(ToolSection Tool, int Number, int Count, int From, int Until)
{
    public bool IsLast => Number == Count;

    /// <summary>The sections of a job in their order.</summary>
    /// <param name="program">Of the job, whole.</param>
    /// <returns>Empty for a job of one section.</returns>
    public static IReadOnlyList<JobSection> Of(PreparedJob job, MotionProgram program)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(program);
        if (job.Sections is not { Count: > 1 } tools) return [];
        var (sections, stroke, from) = (new List<JobSection>(), 0, 0);
        foreach (var tool in tools)
        {
            var until = from;
            for (; stroke < program.Strokes.Count && program.Strokes[stroke].Index < tool.EndStroke; stroke++) until += program.Strokes[stroke].SegmentCount;
            sections.Add(new JobSection(tool, sections.Count + 1, tools.Count, from, until));
            from = until;
        }

        return sections;
    }

    /// <summary>The section that is cut next.</summary>
    /// <param name="place">Everything before it is cut.</param>
    /// <returns>Null for a job of one section, or where nothing is left.</returns>
    public static JobSection? At(PreparedJob job, MotionProgram program, JobPosition place) => Of(job, program).FirstOrDefault(section => place.Segments < section.Until);

    /// <summary>The section behind this one, which is not the last.</summary>
    public ToolSection Next(PreparedJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return job.Sections[Number];
    }

    /// <summary>The outcome of a run that completes this section, which is not the last.</summary>
    public JobOutcome OutcomeIn(PreparedJob job) => Next(job).Repeat is null ? JobOutcome.ToolChange : JobOutcome.OperatorStop;

    /// <summary>The strokes of the program up to the end of this section.</summary>
    public MotionProgram UpToEnd(MotionProgram program)
    {
        ArgumentNullException.ThrowIfNull(program);
        return program.Until(Until);
    }

    /// <summary>The strokes of this section.</summary>
    public MotionProgram Of(MotionProgram program)
    {
        ArgumentNullException.ThrowIfNull(program);
        return program with { Strokes = [.. program.Strokes.Where(stroke => stroke.Index >= Tool.FirstStroke && stroke.Index < Tool.EndStroke)] };
    }

    /// <summary>The job with the rows of this section as what its run is compared with.</summary>
    public PreparedJob JudgedOf(PreparedJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        var first = job.Sequence.Strokes.Take(Tool.FirstStroke).Sum(stroke => stroke.Moves.Count);
        var rows = job.Sequence.Strokes.Skip(Tool.FirstStroke).Take(Tool.Strokes).Sum(stroke => stroke.Moves.Count);
        return job with { Analysed = job.Analysed.Picking([.. Enumerable.Range(first, rows)]) };
    }
}
