using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Posts;
using Engraver.Core.Sequencing;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>Everything that follows from a document: table, strokes, job, findings, plan, program text. Immutable. What could not be made is null, and
/// <see cref="Problem"/> or the findings say why.</summary>
/// <param name="State">What it was made from (what is selected does not matter).</param>
/// <param name="Mode">The execution strategy that the job was prepared for.</param>
public sealed record DerivedDocument(DocumentState State, JobMode Mode)
{
    public static DerivedDocument Nothing { get; } = new(DocumentState.Nothing, JobMode.Stream);

    /// <summary>The table of what is to be cut, as drawn.</summary>
    public EntityTable? Analysed => Job?.Analysed;

    /// <summary>Strokes in order, discontinuities, the table in sequence order.</summary>
    public SequencingResult? Sequence => Job?.Sequence;

    public PreparedJob? Job { get; init; }

    /// <summary>The serial line that <see cref="Plan"/> counts; null: a network.</summary>
    public SerialAddress? Line { get; init; }

    /// <summary>The planned time by kind, over <see cref="Line"/>; null when there is nothing to cut.</summary>
    public MotionTimes? Plan { get; init; }

    /// <summary>The planned motion; null when there is nothing to cut.</summary>
    public PlannedMotion? Motion { get; init; }

    private Lazy<PostText?> Posted { get; init; } = new((PostText?)null);

    /// <summary>The posted program of the machine's own controller; null when there is nothing to cut. Written when it is first asked for, which takes a
    /// while: only a page that shows it asks.</summary>
    public PostText? Program => Posted.Value;

    /// <summary>False while nobody has asked for <see cref="Program"/>.</summary>
    public bool IsPosted => Posted.IsValueCreated;

    /// <summary>Findings of every stage, worst first, in the words of the command line.</summary>
    public IReadOnlyList<Diagnostic> Findings { get; init; } = [];

    /// <summary>A setting that does not fit the drawing, in one sentence; null when all do.</summary>
    public string? Problem { get; init; }

    /// <summary>All stages. Between two of them a cancellation is honoured.</summary>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static DerivedDocument Create(DocumentState state, JobMode mode, CancellationToken cancellation, IProgress<DerivationStage>? progress = null)
    {
        var derived = new DerivedDocument(state, mode);
        if (state.Drawing is not { } drawing) return derived;
        try
        {
            cancellation.ThrowIfCancellationRequested();
            var job = JobPreparation.PrepareUnlessCancelled(drawing, state.Settings, JobPlan.StyleOf(mode), cancellation, progress);
            progress?.Report(DerivationStage.Program);
            return (derived with { Job = job }).WithMotion(job, cancellation);
        }
        catch (SettingException unfit)
        {
            return derived with { Problem = unfit.Message, Findings = Sorted(drawing.Diagnostics) };
        }
    }

    /// <summary>The same document with its plan made for another serial line.</summary>
    internal DerivedDocument Over(SerialAddress? line)
    {
        if (line == Line) return this;
        if (Job is not { Motion.Program: { SegmentCount: > 0 } program, Drawing: var drawing }) return this with { Line = line };
        var fit = JobPlan.FitToLink(program, line, Mode, drawing).Program;
        return this with { Line = line, Plan = line is null ? JobPlan.NetworkTimes(program) : JobPlan.PlannedTimes(fit, line, Mode) };
    }

    private DerivedDocument WithMotion(PreparedJob job, CancellationToken cancellation)
    {
        if (job.Motion.Program is not { SegmentCount: > 0 } program) return this with { Findings = Sorted(job.Diagnostics) };
        var (post, request) = (PostTable.ForMotion(program.Style).Post, new PostRequest(job.Toolpath, program, job.Drawing.SourceOf, PostedProgram.NoOptions) { Machine = job.Settings.Machine, MaxErrorMm = job.Settings.MaxErrorMm });
        var posted = new Lazy<PostText?>(() => post.Write(request));
        var findings = post.Findings(request);
        cancellation.ThrowIfCancellationRequested();
        return this with
        {
            Plan = JobPlan.NetworkTimes(program),
            Posted = posted,
            Motion = PlannedMotion.Create(program, job.Toolpath, MachineFamilies.Driver.NetworkTimes, () => posted.Value!.SegmentLines, cancellation),
            Findings = Sorted([.. job.Diagnostics, .. findings]),
        };
    }

    private static IReadOnlyList<Diagnostic> Sorted(IEnumerable<Diagnostic> findings) => [.. findings.OrderByDescending(found => found.Severity).Select(SettingWording.AtCommandLine)];
}
