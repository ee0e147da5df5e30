using System.Diagnostics;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Kerf;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>The stages from a drawing to its motion program, with the operator's settings converted to the options of each.</summary>
public static class JobPreparation
{
    /// <summary>Join tolerance of computed contours, whose ends coincide except for rounding; millimetres.</summary>
    internal const double ExactJoint = 1e-6;

    /// <summary>The fixed-slot table of the selected layers, arcs analysed, file order.</summary>
    /// <exception cref="SettingException">A named layer is not in the drawing.</exception>
    public static EntityTable Analyse(Drawing drawing, DrawingSettings settings)
    {
        CheckLayers(drawing, settings);
        return ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, SelectionOf(settings)));
    }

    /// <summary>Checks that the named layers exist. Skipped for a drawing that could not be read.</summary>
    /// <exception cref="SettingException">A named layer is not in the drawing.</exception>
    public static void CheckLayers(Drawing drawing, DrawingSettings settings)
    {
        if (drawing.Layers.Count > 0 && SelectionOf(settings).UnknownNames(drawing.Layers) is { Count: > 0 } unknown) throw SettingException.UnknownLayers(unknown, drawing.Layers);
    }

    /// <summary>Findings on the drawing before it is cut (<see cref="CutFindings"/>).</summary>
    public static IReadOnlyList<Diagnostic> Findings(Drawing drawing, DrawingSettings settings) =>
        CutFindings.Find(drawing, SelectionOf(settings), settings.Start, settings.JoinToleranceMm, cutsHeights: settings.Machine.Height is not null);

    /// <summary>The layers that are cut.</summary>
    public static LayerSelection SelectionOf(DrawingSettings settings) => new(settings.Layers ?? [], settings.SkippedLayers);

    /// <summary>The table that is cut: as drawn, or compensated for the tool radius.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static CutTable ToCut(Drawing drawing, DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        var analysed = Analyse(drawing, settings);
        if (settings.Kerf == KerfSide.Off) return new CutTable(analysed, null, []);
        var chained = Sequencer.Chain(analysed, drawing, SequencingFor(drawing, settings));
        var options = new KerfOptions(settings.Kerf, settings.ToolDiameterMm, settings.MaxErrorMm, settings.JoinToleranceMm, settings.Machine.Height is not null);
        var kerf = KerfCompensation.Compensate(chained, options);
        return new CutTable(kerf.Table, kerf, [.. chained.Diagnostics, .. kerf.Diagnostics]);
    }

    /// <summary>Contours, order and discontinuities of the cut table. Compensated contours meet exactly, because their segments may be shorter than the join
    /// tolerance.</summary>
    /// <exception cref="SettingException">The entry entity is not in the drawing.</exception>
    public static SequencingResult Sequence(Drawing drawing, CutTable cut, DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(cut);
        return Sequencer.Sequence(cut.Table, drawing, SequencingFor(drawing, cut, settings));
    }

    /// <summary>The settings as options of the sequencer for the cut table.</summary>
    /// <exception cref="SettingException">The entry entity is not in the drawing.</exception>
    public static SequencingOptions SequencingFor(Drawing drawing, CutTable cut, DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(cut);
        var options = SequencingFor(drawing, settings);
        if (cut.Kerf is not { } kerf) return options;
        return options with { JoinTolerance = kerf.KeepsOpen ? options.JoinTolerance : Math.Min(options.JoinTolerance, ExactJoint), KeepDuplicates = true, ArcTolerance = null };
    }

    /// <summary>The cut table in cutting order, with the findings of the tool radius compensation.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static (EntityTable Table, IReadOnlyList<Diagnostic> Findings) CutTableOf(Drawing drawing, DrawingSettings settings)
    {
        var cut = ToCut(drawing, settings);
        return (Sequence(drawing, cut, settings).Table, cut.Kerf?.Diagnostics ?? []);
    }

    /// <summary>Contours, order, discontinuities.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static SequencingResult Sequence(Drawing drawing, EntityTable analysed, DrawingSettings settings) =>
        Sequencer.Sequence(analysed, drawing, SequencingFor(drawing, settings));

    /// <summary>The settings as options of the sequencer.</summary>
    /// <exception cref="SettingException">The entry entity is not in the drawing.</exception>
    public static SequencingOptions SequencingFor(Drawing drawing, DrawingSettings settings) => new()
    {
        JoinTolerance = settings.JoinToleranceMm,
        DuplicateTolerance = settings.MaxErrorMm,
        KeepDuplicates = settings.KeepDuplicates,
        ArcTolerance = settings.RecoverArcs ? settings.MaxErrorMm : null,
        ToolStart = settings.Start,
        Order = settings.Order,
        Enter = Entering(drawing, settings.Enter),
        CutsHeights = settings.Machine.Height is not null,
    };

    /// <summary>The machine-neutral path from the tool's start point.</summary>
    public static Toolpath PathOf(SequencingResult sequence, DrawingSettings settings) => ToolpathPlanner.Plan(sequence, settings.Start, settings.MaxErrorMm);

    /// <summary>Runs all stages.</summary>
    /// <param name="style">Continuous for streaming and posted sequences, calls for the subroutine calls of paper 000.</param>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static PreparedJob Prepare(Drawing drawing, DrawingSettings settings, MotionStyle style) => PrepareUnlessCancelled(drawing, settings, style, CancellationToken.None);

    /// <summary>Runs all stages; cancellation is checked between them.</summary>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static PreparedJob PrepareUnlessCancelled(Drawing drawing, DrawingSettings settings, MotionStyle style, CancellationToken cancellation, IProgress<DerivationStage>? progress = null)
    {
        progress?.Report(DerivationStage.Table);
        var cut = ToCut(drawing, settings);
        cancellation.ThrowIfCancellationRequested();
        progress?.Report(DerivationStage.Order);
        var sequence = Sequence(drawing, cut, settings);
        cancellation.ThrowIfCancellationRequested();
        progress?.Report(DerivationStage.Path);
        var toolpath = PathOf(sequence, settings);
        cancellation.ThrowIfCancellationRequested();
        progress?.Report(DerivationStage.Motion);
        var job = FromPath(drawing, settings, cut.Table, sequence, toolpath, style);
        return job with { Kerf = cut.Kerf, Findings = [.. job.Findings, .. cut.FindingsBeside(sequence)] };
    }

    /// <summary>The last stages: the motion of a toolpath that matches the drawing. Otherwise there is no program, and the faults state the
    /// positions.</summary>
    public static PreparedJob FromPath(Drawing drawing, DrawingSettings settings, EntityTable analysed, SequencingResult sequence, Toolpath toolpath, MotionStyle style)
    {
        var motion = MachineFamilies.DriverOf(settings.Machine).Generate(toolpath, settings.Machine, settings.MaxErrorMm, drawing.SourceOf, style);
        var faults = motion.Program is null ? [] : FaultsOf(drawing, settings, analysed, toolpath);
        var program = faults.Count > 0 || motion.Program is not { } made ? null : made with { Finish = settings.Finish == FinishPlace.Origin ? made.Start : null }; // The park position is a machine position, known only after the job is placed.
        return new PreparedJob(drawing, settings, analysed, sequence, toolpath, motion with { Program = program }) { Faults = faults, Findings = Findings(drawing, settings) };
    }

    /// <summary>Positions where the toolpath, whose coordinates are finite, differs from the drawing.</summary>
    public static IReadOnlyList<Diagnostic> FaultsOf(Drawing drawing, DrawingSettings settings, EntityTable analysed, Toolpath toolpath) =>
        ToolpathCheck.Findings(analysed, toolpath, new ToolpathTolerances(settings.MaxErrorMm, settings.JoinToleranceMm, settings.RecoverArcs), drawing.SourceOf);

    private static EnterAt? Entering(Drawing drawing, EnteringPlace? place) => place switch
    {
        null => null,
        EnteringPlace.ByPoint point => new EnterAt.AtPlace(point.Point),
        EnteringPlace.ByHandle handle => new EnterAt.AtEntity(drawing.IndexOfHandle(handle.Handle) ?? throw SettingException.UnknownHandle(handle.Handle)),
        _ => throw new UnreachableException(),
    };
}

/// <summary>The entities to cut.</summary>
/// <param name="Table">Analysed rows: as drawn, or the path of the tool centre.</param>
/// <param name="Kerf">The compensation; null without one.</param>
/// <param name="Diagnostics">Findings of chaining the drawing and of the compensation.</param>
public sealed record CutTable(EntityTable Table, KerfResult? Kerf, IReadOnlyList<Diagnostic> Diagnostics)
{
    /// <summary>The findings that the sequencing of the compensated table does not repeat.</summary>
    public IEnumerable<Diagnostic> FindingsBeside(SequencingResult sequence)
    {
        ArgumentNullException.ThrowIfNull(sequence);
        var repeated = sequence.Diagnostics.Select(finding => finding.Id).ToHashSet();
        return Diagnostics.Where(finding => !repeated.Contains(finding.Id));
    }
}
