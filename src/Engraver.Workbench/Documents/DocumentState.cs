using Engraver.Core.Drawings;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Documents;

/// <summary>Everything the operator has before them at one moment: the drawing with its edits, the settings, what is selected. Immutable, so going back to
/// it is exact.</summary>
public sealed record DocumentState
{
    public static DocumentState Nothing { get; } = new();

    /// <summary>Null when no drawing is open.</summary>
    public Drawing? Drawing
    {
        get;
        init => (field, Edition) = (value, value);
    }

    /// <summary>The scale of the drawing, which it has had since it was opened or created; millimetres while none is open. A unit that is set
    /// (<see cref="DrawingSettings.Unit"/>) is for the next drawing that is opened.</summary>
    public DrawingScale Scale => Drawing?.Scale ?? DrawingScale.Millimetres;

    /// <summary>Which edition of the drawing it is: another one after every edit, the same one (set behind <see cref="Drawing"/>) while objects are only
    /// hidden and shown, which no file keeps.</summary>
    public Drawing? Edition { get; init; }

    public DrawingSettings Settings { get; init; } = new();

    /// <summary>Name of the layer on which new objects are drawn (CLAYER). Where the drawing has no such layer, they go on layer 0
    /// (<see cref="Documents.CurrentLayer"/>).</summary>
    public string CurrentLayer { get; init; } = Documents.CurrentLayer.First;

    /// <summary>What belongs to the drawing and stands in a file of its own beside it: trajectories.</summary>
    public Sidecar Sidecar { get; init; } = Sidecar.Empty;

    /// <summary>Indices into the drawing's entities, each once, in the order in which they were picked.</summary>
    public IReadOnlyList<int> Selection { get; init; } = [];

    /// <summary>What HIDEOBJECTS has hidden, by its indices: only that is shown again by UNISOLATEOBJECTS, not what the file itself hides.</summary>
    public IReadOnlyList<int> HiddenObjects { get; init; } = [];

    /// <summary>What the last command worked on ("Previous").</summary>
    public IReadOnlyList<int> Previous { get; init; } = [];
}
