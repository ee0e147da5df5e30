using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Kerf;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>A drawing with the result of every stage from table to motion program. Immutable; the findings are kept by stage and all together.</summary>
/// <param name="Analysed">The table of what is to be cut, as drawn or compensated for the radius of the tool: what a run is judged by.</param>
/// <param name="Sequence">The table chained and ordered.</param>
/// <param name="Toolpath">Ordered moves, mm.</param>
/// <param name="Motion">The motion program, or why there is none. There is none for a path that is not the drawing's (see <see cref="Faults"/>).</param>
public sealed record PreparedJob(Drawing Drawing, DrawingSettings Settings, EntityTable Analysed, SequencingResult Sequence, Toolpath Toolpath, MotionGeneration Motion)
{
    /// <summary>What is seen and not cut, heights, size and place (<see cref="JobPreparation.Findings"/>).</summary>
    public IReadOnlyList<Diagnostic> Findings { get; init; } = [];

    /// <summary>The compensation for the radius of the tool; null without one.</summary>
    public KerfResult? Kerf { get; init; }

    /// <summary>The trajectories that are run instead of the drawing, and the document that they belong to; null for a job of the drawing.
    /// <see cref="Drawing"/> is then theirs.</summary>
    public FollowedTrajectories? Followed { get; init; }

    /// <summary>The document's drawing.</summary>
    public Drawing DocumentDrawing => Followed?.Drawing ?? Drawing;

    /// <summary>The settings that a record of the job states: those with which its drawing is opened again and cut in the same way.</summary>
    public DrawingSettings Recorded => (Followed?.Settings ?? Settings).AsOpened(DocumentDrawing);

    /// <summary>What is seen on the layers that are cut and gives no cut.</summary>
    public NotCutFindings NotCut => NotCutFindings.From(Drawing, JobPreparation.SelectionOf(Settings));

    /// <summary>Where the toolpath is not what is drawn (VER0020 to VER0022), which no operator can accept; empty for every job that may be run or
    /// posted.</summary>
    public IReadOnlyList<Diagnostic> Faults { get; init; } = [];

    public IReadOnlyList<Diagnostic> Diagnostics => [.. Drawing.Diagnostics, .. Findings, .. Sequence.Diagnostics, .. Motion.Diagnostics, .. Faults];

    /// <summary>Why there is no motion program or nothing in it, without a full stop.</summary>
    public string WithoutProgram => (Faults.Count, Motion.Program) switch
    {
        ( > 0, _) => NotAsDrawn(Faults),
        (_, null) => Wording.Get("PreparedJob.MachineCannotCut", Ids(Motion.Diagnostics.Where(finding => finding.Severity == Severity.Error))),
        _ => NothingCut(NotCut),
    };

    /// <summary>True for the job of a document as it stands: its drawing and settings, and its trajectories where these are run.</summary>
    public bool IsOf(DocumentState state)
    {
        ArgumentNullException.ThrowIfNull(state);
        if (!ReferenceEquals(DocumentDrawing, state.Drawing)) return false;
        return Followed is { } followed ? followed.Settings == state.Settings && ReferenceEquals(followed.Trajectories, state.Sidecar.Trajectories.All) : Settings == state.Settings;
    }

    /// <summary>The toolpath has these faults; without a full stop.</summary>
    internal static string NotAsDrawn(IReadOnlyList<Diagnostic> faults) => Wording.Get("PreparedJob.ToolpathDeviates", Ids(faults));

    /// <summary>No curve is left on the layers that are cut; without a full stop.</summary>
    internal static string NothingCut(NotCutFindings notCut) => notCut.Counts.Count == 0 ? Wording.Get("PreparedJob.NothingToCut") : Wording.Get("PreparedJob.NothingToCutBecause", notCut.Clause);

    private static string Ids(IEnumerable<Diagnostic> findings) => string.Join(", ", findings.Select(finding => finding.Id).Distinct());
}
