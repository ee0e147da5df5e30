using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Posts;
using Engraver.Core.Sequencing;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Playback;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>All results derived from a document: table, strokes, job, findings, plan, program text. Immutable. Missing results are null; <see cref="Problem"/>
/// or the findings state the reason.</summary>
/// <param name="State">The source state (the selection is irrelevant).</param>
/// <param name="Strategy">The execution strategy that the job was prepared for.</param>
public sealed record DerivedDocument(DocumentState State, ExecutionStrategy Strategy)
{
    public static DerivedDocument Nothing { get; } = new(DocumentState.Nothing, MachineFamilies.Default.DefaultStrategy);

    /// <summary>The table of the entities to cut, as drawn.</summary>
    public EntityTable? Analysed => Job?.Analysed;

    /// <summary>Strokes in order, discontinuities, the table in sequence order.</summary>
    public SequencingResult? Sequence => Job?.Sequence;

    public PreparedJob? Job { get; init; }

    /// <summary>The plate whose values the texts have; null for a drawing without plates.</summary>
    public Plate? Plate { get; init; }

    /// <summary>The serial line used for <see cref="Plan"/>; null: a network.</summary>
    public SerialAddress? Line { get; init; }

    /// <summary>The planned times over <see cref="Line"/>; null if there is nothing to cut.</summary>
    public MotionTimes? Plan { get; init; }

    /// <summary>The planned motion; null when there is nothing to cut.</summary>
    public PlannedMotion? Motion { get; init; }

    private Lazy<PostOutput?> Posted { get; init; } = new((PostOutput?)null);

    /// <summary>The posted program of the machine's own controller; null when there is nothing to cut, or when its family has no post. Written when it is first
    /// requested, which takes a while: only a page that shows it requests it.</summary>
    public PostOutput? Program => Posted.Value;

    /// <summary>True after the first access to <see cref="Program"/>.</summary>
    public bool IsPosted => Posted.IsValueCreated;

    /// <summary>Findings of every stage, worst first, with the names of the command line.</summary>
    public IReadOnlyList<Diagnostic> Findings { get; init; } = [];

    /// <summary>Message about a setting that does not fit the drawing; null if there is none.</summary>
    public string? Problem { get; init; }

    /// <summary>Runs all stages. Cancellation is checked between stages.</summary>
    /// <param name="plate">The plate to show; null for a drawing without plates.</param>
    /// <param name="orderStop">Ends the search for the order early; null if it cannot be ended.</param>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static DerivedDocument Create(DocumentState state, ExecutionStrategy strategy, CancellationToken cancellation, IProgress<JobStage>? progress = null, Plate? plate = null, OrderStop? orderStop = null)
    {
        var derived = new DerivedDocument(state, strategy) { Plate = plate };
        if (state.Drawing is not { } drawing) return derived;
        try
        {
            var drawn = PlateJob.Drawn(drawing, state.Settings, strategy.Style, plate) with { OrderStop = orderStop };
            var planned = new StageRun(drawn, cancellation, progress).To<PlannedJob>();
            var job = PreparedJob.From(planned) with { Plate = plate };
            return derived with
            {
                Job = job,
                Plan = job.Motion.Program is { SegmentCount: > 0 } program ? JobPlan.NetworkTimes(program) : null,
                Posted = planned.Posted,
                Motion = planned.Planned,
                Findings = Sorted([.. job.Diagnostics, .. planned.PostFindings]),
            };
        }
        catch (SettingException unfit)
        {
            return derived with { Problem = unfit.Message, Findings = Sorted(drawing.Diagnostics) };
        }
    }

    /// <summary>The same document with a plan for another serial line.</summary>
    internal DerivedDocument WithLine(SerialAddress? line)
    {
        if (line == Line) return this;
        if (Job is not { Motion.Program: { SegmentCount: > 0 } program, Drawing: var drawing }) return this with { Line = line };
        var fit = JobPlan.FitToLink(program, line, Strategy, drawing).Program;
        return this with { Line = line, Plan = line is null ? JobPlan.NetworkTimes(program) : JobPlan.PlannedTimes(fit, line, Strategy) };
    }

    private static IReadOnlyList<Diagnostic> Sorted(IEnumerable<Diagnostic> findings) => [.. findings.OrderByDescending(found => found.Severity).Select(SettingWording.AtCommandLine)];
}
