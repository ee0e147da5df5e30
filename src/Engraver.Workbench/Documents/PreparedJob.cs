using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Kerf;
using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Workbench.Composition;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>A drawing with the result of every stage from table to motion program. Immutable; findings are available by stage and combined.</summary>
/// <param name="Analysed">The table of the entities to cut, as drawn or compensated for the tool radius; the reference for judging a run.</param>
/// <param name="Sequence">The table chained and ordered.</param>
/// <param name="Toolpath">Ordered moves, mm.</param>
/// <param name="Motion">The motion program, or why there is none. There is none if the path differs from the drawing (see <see cref="Faults"/>).</param>
public sealed record PreparedJob(Drawing Drawing, DrawingSettings Settings, EntityTable Analysed, SequencingResult Sequence, Toolpath Toolpath, MotionGeneration Motion)
{
    /// <summary>Visible but uncut entities, heights, size and position (<see cref="JobPreparation.Findings"/>).</summary>
    public IReadOnlyList<Diagnostic> Findings { get; init; } = [];

    /// <summary>The compensation for the tool radius; null without one.</summary>
    public KerfResult? Kerf { get; init; }

    /// <summary>The drawing from which the stages started; <see cref="Drawing"/> unless a stage replaced it.</summary>
    public Drawing Source { get; init; } = Drawing;

    /// <summary>The plate with the values of its texts and its place; null for a drawing that is not one of several plates.</summary>
    public Plate? Plate { get; init; }

    /// <summary>The fonts of the texts that are cut; empty if none is.</summary>
    public IReadOnlyList<CutFont> Fonts { get; init; } = [];

    /// <summary>The trajectories that replace the drawing, and their document; null for a job of the drawing. <see cref="Drawing"/> then contains their
    /// curves.</summary>
    public FollowedTrajectories? Trajectories { get; init; }

    /// <summary>The document's drawing.</summary>
    public Drawing DocumentDrawing => Trajectories?.Drawing ?? Source;

    /// <summary>The settings that a record of the job states: those with which its drawing is opened again and cut in the same way.</summary>
    public DrawingSettings Recorded => (Trajectories?.Settings ?? Settings).AsOpened(DocumentDrawing);

    /// <summary>Visible entities on the cut layers that produce no cut.</summary>
    public NotCutFindings NotCut => NotCutFindings.From(Drawing, StageOptions.SelectionOf(Settings), NotTaken);

    /// <summary>Curves of the drawing that no operation takes, by entity.</summary>
    public IReadOnlyList<int> NotTaken { get; init; } = [];

    /// <summary>Operation and pass of each stroke; empty for a job without operations.</summary>
    public IReadOnlyList<StrokePass> Passes { get; init; } = [];

    /// <summary>The parts of the job between two changes of the tool or stops, in order; empty for a job without operations.</summary>
    public IReadOnlyList<ToolSection> Sections => Settings.Operations is { } plan ? ToolSection.Of(plan, Passes) : [];

    /// <summary>What the controllers of the machine cannot do of the operations: the job can be posted in another format, but not run.</summary>
    public IReadOnlyList<Diagnostic> RunRefusals => Passes.Count == 0 ? [] : MachineFamilies.DriverOf(Settings.Machine).SupportOf(Settings.CuttingMachine).Refusals(Passes.Select(pass => pass.Operation));

    /// <summary>The shapes of the operations; empty for a job without operations.</summary>
    public IReadOnlyList<ShapedOperation> Shapes { get; init; } = [];

    /// <summary>Differences between toolpath and drawing (VER0020 to VER0022), misplaced letters (VER0023) and fields without a value, which cannot be
    /// accepted; empty for every job that may be run or posted.</summary>
    public IReadOnlyList<Diagnostic> Faults { get; init; } = [];

    /// <summary>Those of <see cref="Faults"/> that are misplaced letters.</summary>
    public IReadOnlyList<Diagnostic> LetterFaults => [.. Faults.Where(fault => fault.Rule == VerificationRules.LettersMisplaced)];

    public IReadOnlyList<Diagnostic> Diagnostics => [.. Drawing.Diagnostics, .. Findings, .. Sequence.Diagnostics, .. Motion.Diagnostics, .. Faults];

    /// <summary>Why there is no motion program or it is empty, without a full stop.</summary>
    public string NoProgramReason => (Faults.Count, Motion.Program) switch
    {
        ( > 0, _) => NotAsDrawn(Faults),
        (_, null) => Wording.Get("PreparedJob.MachineCannotCut", Ids(Motion.Diagnostics.Where(finding => finding.Severity == Severity.Error))),
        _ => NothingCut(NotCut),
    };

    /// <summary>The results of the stages up to the checked motion program.</summary>
    public static PreparedJob From(CheckedJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return new PreparedJob(job.Drawing, job.Settings, job.Cut.Table, job.Sequence, job.Toolpath, job.Motion) { Source = job.Source, Kerf = job.Cut.Kerf, Findings = job.Findings, Faults = job.Faults, Fonts = job.Letters.Fonts, Passes = job.Passes, Shapes = job.Shapes, NotTaken = job.Assignment?.NotTaken ?? [] };
    }

    /// <summary>True if this is the job of a document: same drawing, settings and plate, or same trajectories if these are run.</summary>
    /// <param name="plate">The next plate of the document; null for none.</param>
    public bool IsOf(DocumentState state, Plate? plate)
    {
        ArgumentNullException.ThrowIfNull(state);
        if (!ReferenceEquals(DocumentDrawing, state.Drawing)) return false;
        return Trajectories is { } followed ? followed.Settings == state.Settings && ReferenceEquals(followed.Trajectories, state.Sidecar.Trajectories.All) : Settings == state.Settings && Plate == plate;
    }

    /// <summary>Message about the faults of the toolpath or of the fields in texts, without a full stop.</summary>
    internal static string NotAsDrawn(IReadOnlyList<Diagnostic> faults) => Wording.Get(SerialRules.All.Contains(faults[0].Rule) ? "PreparedJob.FieldsNotFilled" : faults[0].Rule is { } rule && rule != OperationRules.NotAsStated && (OperationRules.All.Contains(rule) || KerfRules.All.Contains(rule) || PocketRules.All.Contains(rule)) ? "PreparedJob.OperationsUnusable" : "PreparedJob.ToolpathDeviates", Ids(faults));

    /// <summary>Message that the cut layers have no curve, without a full stop.</summary>
    internal static string NothingCut(NotCutFindings notCut) => notCut.Counts.Count == 0 ? Wording.Get("PreparedJob.NothingToCut") : Wording.Get("PreparedJob.NothingToCutBecause", notCut.Clause);

    private static string Ids(IEnumerable<Diagnostic> findings) => string.Join(", ", findings.Select(finding => finding.Id).Distinct());
}
