using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Programs.Posting;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>A drawing as a program in one of the formats of the runner's contract. Where nothing is cut there is no text, so that no earlier result is replaced by nothing.</summary>
/// <param name="Text">Null when there is nothing that the machine can cut.</param>
/// <param name="Diagnostics">Of every stage on the way.</param>
public sealed record PostedProgram(string? Text, IReadOnlyList<Diagnostic> Diagnostics)
{
    public const string Galil = "galil";

    /// <summary>Why there is no text, without a full stop.</summary>
    public string WithoutProgram { get; init; } = "";

    public const string GalilCalls = "galil-calls";

    /// <summary>The sequenced, oriented drawing as DXF.</summary>
    public const string CutterLocation = "cldata";

    /// <summary>The targets there are.</summary>
    public static IReadOnlyList<string> Targets { get; } = [Galil, GalilCalls, CutterLocation];

    /// <param name="target">One of <see cref="Targets"/>.</param>
    /// <exception cref="SettingException">A named layer or the entering entity is not in the drawing.</exception>
    public static PostedProgram Create(Drawing drawing, DrawingSettings settings, string target)
    {
        if (drawing.Entities.Count == 0) return NothingCut(drawing, settings, drawing.Diagnostics);
        if (target == CutterLocation)
        {
            var analysed = JobPreparation.Analyse(drawing, settings);
            return OfSequence(drawing, analysed, JobPreparation.Sequence(drawing, analysed, settings), settings);
        }

        return OfJob(JobPreparation.Prepare(drawing, settings, target == GalilCalls ? MotionStyle.Calls : MotionStyle.Continuous));
    }

    /// <summary>The program of a job, in the style that it was prepared in.</summary>
    public static PostedProgram OfJob(PreparedJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        if (job.Sequence.Contours == 0) return new PostedProgram(null, [.. job.Diagnostics, DocumentRules.NothingToPost.At(default)]) { WithoutProgram = job.WithoutProgram };
        if (job.Motion.Program is not { } program) return new PostedProgram(null, job.Diagnostics) { WithoutProgram = job.WithoutProgram };
        var post = program.Style == MotionStyle.Calls
            ? DmcPost.Calls(program, DmcPostOptions.Default, job.Drawing.SourceOf)
            : DmcPost.Sequences(program, DmcPostOptions.Default, job.Drawing.SourceOf);
        return new PostedProgram(post.Text, [.. job.Diagnostics, .. post.Diagnostics]);
    }

    /// <summary>The sequenced, oriented drawing as DXF.</summary>
    /// <param name="analysed">The table that was sequenced.</param>
    /// <param name="sequence">Of <paramref name="drawing"/>, with <paramref name="settings"/>.</param>
    public static PostedProgram OfSequence(Drawing drawing, EntityTable analysed, SequencingResult sequence, DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(sequence);
        IReadOnlyList<Diagnostic> found = [.. drawing.Diagnostics, .. JobPreparation.Findings(drawing, settings), .. sequence.Diagnostics];
        if (sequence.Contours == 0) return NothingCut(drawing, settings, found);
        var path = new Toolpath(settings.Start, [.. sequence.Strokes.Select(stroke => new ToolpathStroke(stroke.Index, stroke.Closed, stroke.Moves))]);
        if (JobPreparation.FaultsOf(drawing, settings, analysed, path) is { Count: > 0 } faults) return new PostedProgram(null, [.. found, .. faults]) { WithoutProgram = PreparedJob.NotAsDrawn(faults) };
        using var text = new StringWriter { NewLine = "\n" };
        ClData.Write(sequence, settings.Start, text);
        return new PostedProgram(text.ToString(), found);
    }

    private static PostedProgram NothingCut(Drawing drawing, DrawingSettings settings, IReadOnlyList<Diagnostic> found) =>
        new(null, DrawingFile.IsUnreadable(drawing) ? found : [.. found, DocumentRules.NothingToPost.At(default)]) { WithoutProgram = PreparedJob.NothingCut(NotCutFindings.From(drawing, JobPreparation.SelectionOf(settings))) };
}
