using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>The job of one section alone, as a program of its own cuts it: ordered from the start point as the job of its tool.</summary>
internal static class SectionJob
{
    /// <summary>The sections of a job in their order.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static IReadOnlyList<ToolSection> SectionsOf(Drawing drawing, DrawingSettings settings, PlateValues? values) =>
        settings.Operations is { } plan ? ToolSection.Of(plan, JobPreparation.To<OrderedJob>(drawing, settings, values).Passes) : [];

    /// <summary>The job of a section with its number.</summary>
    /// <param name="number">From 1.</param>
    /// <exception cref="SettingException">The job has no such section, or a named layer or the entry entity is not in the drawing.</exception>
    public static PreparedJob Prepare(Drawing drawing, DrawingSettings settings, MotionStyle style, int number, PlateValues? values, CancellationToken cancellation)
    {
        var sections = SectionsOf(drawing, settings, values);
        if (number > sections.Count) throw new SettingException(Wording.Get("SectionJob.NoSection", number, sections.Count));
        var section = sections[number - 1];
        return Within(JobPreparation.PrepareUnlessCancelled(drawing, settings with { Tool = section.Tool.Number }, style, cancellation, values), section);
    }

    /// <summary>The job of a tool with the strokes of one of its sections only.</summary>
    /// <param name="job">Its strokes may have another order than in the job of all tools.</param>
    public static PreparedJob Within(PreparedJob job, ToolSection section)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(section);
        var own = section.Passes.Select(pass => (pass.Operation.Id, pass.Pass)).ToHashSet();
        var kept = Enumerable.Range(0, job.Passes.Count).Where(stroke => own.Contains((job.Passes[stroke].Operation.Id, job.Passes[stroke].Pass))).ToList();
        var (rows, row) = (new List<int>(), 0);
        for (var stroke = 0; stroke < job.Passes.Count; stroke++)
        {
            var moves = job.Sequence.Strokes[stroke].Moves.Count;
            if (own.Contains((job.Passes[stroke].Operation.Id, job.Passes[stroke].Pass))) rows.AddRange(Enumerable.Range(row, moves));
            row += moves;
        }

        return job with
        {
            Passes = [.. kept.Select(stroke => job.Passes[stroke])],
            Sequence = job.Sequence with { Strokes = [.. kept.Select(stroke => job.Sequence.Strokes[stroke])] },
            Toolpath = job.Toolpath with { Strokes = [.. kept.Select(stroke => job.Toolpath.Strokes[stroke])] },
            Analysed = job.Analysed.Picking([.. rows]),
            Motion = job.Motion.Program is { } program ? job.Motion with { Program = program with { Strokes = [.. program.Strokes.Where(stroke => kept.Contains(stroke.Index))] } } : job.Motion,
        };
    }
}
