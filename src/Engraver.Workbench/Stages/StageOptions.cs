using System.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>The settings of the operator as options of several stages.</summary>
public static class StageOptions
{
    /// <summary>Join tolerance of computed contours, whose ends coincide except for rounding; millimetres.</summary>
    internal const double ExactJoint = 1e-6;

    /// <summary>The layers that are cut.</summary>
    public static LayerSelection SelectionOf(DrawingSettings settings) => new(settings.Layers ?? [], settings.SkippedLayers);

    /// <summary>Checks that the named layers exist. Skipped for a drawing that could not be read.</summary>
    /// <exception cref="SettingException">A named layer is not in the drawing.</exception>
    public static void CheckLayers(Drawing drawing, DrawingSettings settings)
    {
        if (drawing.Layers.Count > 0 && SelectionOf(settings).UnknownNames(drawing.Layers) is { Count: > 0 } unknown) throw SettingException.UnknownLayers(unknown, drawing.Layers);
    }

    /// <summary>The options of the sequencer for entities as drawn.</summary>
    /// <exception cref="SettingException">The entry entity is not in the drawing.</exception>
    public static SequencingOptions SequencingFor(Drawing drawing, DrawingSettings settings) => new()
    {
        JoinTolerance = settings.JoinToleranceMm,
        DuplicateTolerance = settings.MaxErrorMm,
        KeepDuplicates = settings.KeepDuplicates,
        ArcTolerance = settings.RecoverArcs ? settings.MaxErrorMm : null,
        ToolStart = settings.Start,
        Order = settings.Order,
        ToolEnd = settings.Finish == FinishPlace.Origin ? settings.Start : null,
        Entry = Entering(drawing, settings.Enter),
        CutsHeights = settings.Machine.Height is not null,
    };

    /// <summary>The options of the sequencer for the cut table. Compensated contours meet exactly, because their segments may be shorter than the join
    /// tolerance.</summary>
    /// <exception cref="SettingException">The entry entity is not in the drawing.</exception>
    internal static SequencingOptions SequencingFor(CompensatedJob job)
    {
        var options = SequencingFor(job.Drawing, job.Settings);
        if (job.Cut.Kerf is not { } kerf) return options;
        return options with { JoinTolerance = kerf.HasOpenContours ? options.JoinTolerance : Math.Min(options.JoinTolerance, ExactJoint), KeepDuplicates = true, ArcTolerance = null };
    }

    private static EntryRequest? Entering(Drawing drawing, ContourEntry? place) => place switch
    {
        null => null,
        ContourEntry.ByPoint point => new EntryRequest.AtPlace(point.Point),
        ContourEntry.ByHandle handle => new EntryRequest.AtEntity(drawing.IndexOfHandle(handle.Handle) ?? throw SettingException.UnknownHandle(handle.Handle)),
        _ => throw new UnreachableException(),
    };
}
