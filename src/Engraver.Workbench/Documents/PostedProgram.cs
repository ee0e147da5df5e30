using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Operations;
using Engraver.Core.Posts;
using Engraver.Core.Toolpaths;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>A drawing as a program in one of the formats of the post table. If nothing is cut there is no text, to avoid overwriting an earlier result with an
/// empty one.</summary>
/// <param name="Text">Null if the machine can cut nothing.</param>
/// <param name="Diagnostics">Findings of all stages.</param>
public sealed record PostedProgram(string? Text, IReadOnlyList<Diagnostic> Diagnostics)
{
    /// <summary>All options of a post at their defaults.</summary>
    public static IReadOnlyDictionary<string, string> NoOptions { get; } = new Dictionary<string, string>();

    /// <summary>The machine position after each block, for posts with a forecast.</summary>
    public PostForecast? Forecast { get; init; }

    /// <summary>Why there is no text, without a full stop.</summary>
    public string NoProgramReason { get; init; } = "";

    /// <param name="options">All options of the post by name.</param>
    /// <param name="values">What the fields in texts stand for; null for none.</param>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static PostedProgram Create(Drawing drawing, DrawingSettings settings, IPost post, IReadOnlyDictionary<string, string> options, PlateValues? values = null)
    {
        ArgumentNullException.ThrowIfNull(post);
        var lettered = JobPreparation.To<LetteredJob>(drawing, settings, values);
        if (lettered.Drawing.Entities.Count == 0 && settings.Operations is null) return CreateEmpty(lettered.Drawing, settings, [.. drawing.Diagnostics, .. lettered.Findings]);
        if (post.Motion is { } style) return FromJob(JobPreparation.Prepare(drawing, settings, style, values), post, options);
        var ordered = JobPreparation.To<OrderedJob>(drawing, settings, values);
        var posted = FromSequence(ordered, post, options);
        return posted with { Diagnostics = [.. posted.Diagnostics, .. ordered.Cut.FindingsBeside(ordered.Sequence)] };
    }

    /// <summary>The program of a job that was prepared in the style of the post.</summary>
    /// <param name="withoutStops">The stops between repeats are left out: the motion of all repeats in one program.</param>
    public static PostedProgram FromJob(PreparedJob job, IPost post, IReadOnlyDictionary<string, string> options, bool withoutStops = false)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(post);
        if (job.Sequence.Contours == 0) return new PostedProgram(null, [.. job.Diagnostics, DocumentRules.NothingToPost.At(default)]) { NoProgramReason = job.NoProgramReason };
        if (job.Motion.Program is not { } program) return new PostedProgram(null, job.Diagnostics) { NoProgramReason = job.NoProgramReason };
        if (ToolSection.RefusalOfSeveral(job.Sections) is { } several && !(withoutStops && several.Rule == OperationRules.SeveralPrograms)) return new PostedProgram(null, [.. job.Diagnostics, several]) { NoProgramReason = Wording.Get("PostedProgram.NotWritable", several.Id) };
        var request = new PostRequest(job.Toolpath, program, job.Drawing.SourceOf, options) { Machine = job.Settings.CuttingMachine, MaxErrorMm = job.Settings.MaxErrorMm };
        return Written(post, request, job.Passes, job.Diagnostics);
    }

    /// <summary>The program of a post that writes the path in millimetres.</summary>
    public static PostedProgram FromSequence(OrderedJob job, IPost post, IReadOnlyDictionary<string, string> options)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(post);
        var (drawing, settings, sequence) = (job.Drawing, job.Settings, job.Sequence);
        if (settings.Operations is not null && post.OperationsRefusal is { } reason) return new PostedProgram(null, [.. drawing.Diagnostics, OperationRules.NotPosted.At(default, post.Name, reason)]) { NoProgramReason = Wording.Get("PostedProgram.NotWritable", OperationRules.NotPosted.Id) };
        // Whether a speed is set depends on the format: the post reports it.
        IReadOnlyList<Diagnostic> found = [.. drawing.Diagnostics, .. JobPreparation.Findings(job).Where(finding => finding.Rule != OperationRules.SpindleByHand), .. sequence.Diagnostics];
        if (job.OperationFaults is { Count: > 0 } unusable) return new PostedProgram(null, [.. found, .. unusable]) { NoProgramReason = PreparedJob.NotAsDrawn(unusable) };
        if (sequence.Contours == 0) return CreateEmpty(drawing, settings, found);
        var path = post.Geometry == PostGeometry.LinesAndArcs ? PathStage.ToolpathOf(job) : ToolpathPlanner.WithCurves(sequence, settings.Start);
        if (CheckStage.FaultsOf(job, path) is { Count: > 0 } faults) return new PostedProgram(null, [.. found, .. faults]) { NoProgramReason = PreparedJob.NotAsDrawn(faults) };
        return Written(post, new PostRequest(path, null, drawing.SourceOf, options) { Machine = settings.CuttingMachine, MaxErrorMm = settings.MaxErrorMm, Operations = OperationsOf(job) }, job.Passes, found);
    }

    private static PostOperations? OperationsOf(OrderedJob job) => job.Settings.Operations is { } plan && ToolSection.Of(plan, job.Passes) is { Count: > 0 } sections ? new PostOperations(plan, sections) : null;

    private static PostedProgram Written(IPost post, PostRequest request, IReadOnlyList<StrokePass> passes, IReadOnlyList<Diagnostic> found)
    {
        var written = passes.Count > 0 && post.SupportOf(request).Refusals(passes.Select(pass => pass.Operation)) is { Count: > 0 } refused ? new PostOutput([], refused) : post.Write(request);
        IReadOnlyList<Diagnostic> all = [.. found, .. written.Diagnostics];
        if (written.Chunks.Count > 0) return new PostedProgram(written.Text, all) { Forecast = written.Forecast };
        return new PostedProgram(null, all) { NoProgramReason = Wording.Get("PostedProgram.NotWritable", string.Join(", ", written.Diagnostics.Select(finding => finding.Id).Distinct())) };
    }

    private static PostedProgram CreateEmpty(Drawing drawing, DrawingSettings settings, IReadOnlyList<Diagnostic> found) =>
        new(null, DrawingFile.IsUnreadable(drawing) ? found : [.. found, DocumentRules.NothingToPost.At(default)]) { NoProgramReason = PreparedJob.NothingCut(NotCutFindings.From(drawing, StageOptions.SelectionOf(settings))) };
}
