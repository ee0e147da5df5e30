using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Documents;

/// <summary>A state of the document: drawing with edits, settings, selection. Immutable, so undo restores it exactly.</summary>
public sealed record DocumentState
{
    public static DocumentState Nothing { get; } = new();

    /// <summary>Null when no drawing is open.</summary>
    public Drawing? Drawing
    {
        get;
        init
        {
            if (field is { } before && value is { } after) (Selection, Previous) = (Following(Selection, before, after), Following(Previous, before, after));
            (field, Edition, Unplaced) = (value, value, null);
        }
    }

    /// <summary>The scale of the drawing, which it has had since it was opened or created; millimetres while none is open. A unit that is set
    /// (<see cref="DrawingSettings.Unit"/>) is for the next drawing that is opened.</summary>
    public DrawingScale Scale => Drawing?.Scale ?? DrawingScale.Millimetres;

    /// <summary>The edition of the drawing: changes with every edit, but not when objects are hidden and shown, which is not saved. Set after
    /// <see cref="Drawing"/>.</summary>
    public Drawing? Edition { get; init; }

    /// <summary>The drawing before it was placed; null for one without placement, and after an edit, which is made in placed coordinates. Set after
    /// <see cref="Drawing"/>.</summary>
    public Drawing? Unplaced { get; init; }

    public DrawingSettings Settings { get; init; } = new();

    /// <summary>The settings with which the next drawing is opened: without those that belong to this one.</summary>
    public DrawingSettings SettingsOfNext => Settings with { Enter = null, Layers = null, SkippedLayers = [], Operations = null, Tool = 0, Placement = DrawingPlacement.None, Cut = CutsTexts ? Settings.Cut & ~CutChoice.Text : Settings.Cut };

    /// <summary>Name of the layer on which new objects are drawn (CLAYER). If the drawing has no such layer, layer 0 is used
    /// (<see cref="Documents.CurrentLayer"/>).</summary>
    public string CurrentLayer { get; init; } = Documents.CurrentLayer.DefaultName;

    /// <summary>Name of the style of new texts; Standard if the drawing has no such style.</summary>
    public string CurrentStyle { get; init; } = "Standard";

    /// <summary>The operator has chosen to cut the texts of this drawing: the choice ends with it.</summary>
    public bool CutsTexts { get; init; }

    /// <summary>The content of the sidecar: trajectories.</summary>
    public Sidecar Sidecar { get; init; } = Sidecar.Empty;

    /// <summary>Indices into the entities of the drawing as it is shown (<see cref="LetteredDrawings.ShownDrawing"/>), each once, in the order in which they
    /// were picked.</summary>
    public IReadOnlyList<int> Selection { get; init; } = [];

    /// <summary>Indices of the objects hidden by HIDEOBJECTS: only these are shown again by UNISOLATEOBJECTS, not objects hidden in the file.</summary>
    public IReadOnlyList<int> HiddenObjects { get; init; } = [];

    /// <summary>The objects of the last command ("Previous").</summary>
    public IReadOnlyList<int> Previous { get; init; } = [];

    /// <summary>The document with its drawing placed, which is not an edit: the file does not change.</summary>
    /// <returns>The document; or why the drawing cannot be placed so.</returns>
    /// <exception cref="InvalidOperationException">No drawing is open.</exception>
    public (DocumentState? Placed, Diagnostic? Refusal) PlacedBy(DrawingPlacement placement)
    {
        var drawing = Drawing ?? throw new InvalidOperationException();
        var settings = Settings with { Placement = placement };
        var source = drawing.Placement.IsNone ? drawing : Unplaced;
        var (placed, refusal) = source is not null && placement.IsNone ? (source, null) : PlacedDrawing.Try(source ?? drawing, settings, source is null ? drawing.PlacementMap.Inverse() : Transform2D.Identity);
        return (placed is null ? null : this with { Drawing = placed, Unplaced = placement.IsNone ? null : source, Edition = Edition, Settings = settings }, refusal);
    }

    /// <summary>The document whose placement is in the coordinates of its file, because they were saved.</summary>
    public DocumentState WithPlacementSaved() => Drawing is not { Placement.IsNone: false } drawing
        ? this
        : this with
        {
            Drawing = drawing with { Placement = DrawingPlacement.None, PlacementMap = Transform2D.Identity },
            Settings = Settings with { Placement = DrawingPlacement.None, Operations = Settings.Operations?.PlacedOn(drawing) },
            Sidecar = Sidecar with { Operations = Sidecar.Operations?.PlacedOn(drawing) },
        };

    /// <summary>The same objects after an edit: the indices of texts follow those of the curves.</summary>
    internal static IReadOnlyList<int> Following(IReadOnlyList<int> objects, Drawing before, Drawing after)
    {
        var (curves, added) = (before.Entities.Count, after.Entities.Count - before.Entities.Count);
        return added == 0 || !objects.Any(index => index >= curves) ? objects : [.. objects.Select(index => index >= curves ? index + added : index)];
    }
}
