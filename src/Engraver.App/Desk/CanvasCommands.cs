using System.Globalization;
using Engraver.App.Canvas;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.App.Desk;

/// <summary>Converts what the operator does on the canvas to inputs of the command session.</summary>
/// <param name="cancel">Esc, while no box is being drawn.</param>
/// <param name="pointed">The cursor has moved to a point of the drawing.</param>
/// <param name="menu">The right button, except where it means Enter: a command that requests objects, or has no options (as AutoCAD's SHORTCUTMENU
/// 11).</param>
public sealed class CanvasCommands(DesktopModel desk, Action cancel, Action<Point2D> pointed, Action menu) : ICanvasCommands
{
    /// <summary>The command that drags a grip.</summary>
    internal const string GripEdit = "GRIPEDIT";

    /// <summary>After the objects at a Shift click are removed, objects are added again.</summary>
    private bool _returnsToAdding;

    public PointRequest? Aim => desk.Prompt.PointRequest;

    /// <summary>The function of the typed line that is shown; the same one while the line is the same, so that it is not computed again.</summary>
    private (Func<string, IReadOnlyList<Segment>>? Typed, string Line, GhostFunction? Preview) _typed;

    public GhostFunction? Preview => desk.Prompt.TypedGhost is { } typed ? PreviewOf(typed, desk.TypedLine) : desk.Prompt.Preview;

    public string Instruction => PromptLine.WithoutOptions(desk.Prompt.Text);

    /// <summary>Selects, and moves the playback to where the entity is cut.</summary>
    /// <remarks>An entity is an index into one drawing: after an edit that the canvas or the plan does not show yet, the index would refer to another
    /// entity.</remarks>
    public void PickAt(Point2D place, int entity, Drawing shown, bool remove)
    {
        _ = desk.SelectAsync(drawing => ReferenceEquals(drawing, shown) ? [entity] : [], remove);
        if (ReferenceEquals(desk.Derived.Current.State.Drawing, shown)) desk.Derived.MoveToEntity(entity);
    }

    public void SelectBox(Point2D from, Point2D to, bool crossing, bool remove)
    {
        var box = Bounds2D.FromCorners(from, to);
        _ = desk.SelectAsync(drawing => [.. crossing ? DrawingPick.Touching(ShownDrawing.Of(drawing), box) : DrawingPick.Inside(ShownDrawing.Of(drawing), box)], remove);
    }

    public void Cancel() => cancel();

    private GhostFunction? PreviewOf(Func<string, IReadOnlyList<Segment>> typed, string line)
    {
        if (_typed.Typed != typed || _typed.Line != line) _typed = (typed, line, _ => typed(line));
        return _typed.Preview;
    }

    public void PointGiven(Point2D place, bool remove) => _ = (remove, Aim) switch
    {
        (true, { ShiftPrefix: { } mark }) => desk.Queue.EnterAsync(string.Create(CultureInfo.InvariantCulture, $"{mark}{place.X:R},{place.Y:R}")),
        (true, { Purpose: PointPurpose.Object, IsDeselecting: false }) => RemoveAsync(place),
        _ => GiveAsync(place),
    };

    public void GripPressed(Point2D grip) => _ = desk.Queue.RunAsync(GripEdit, string.Create(CultureInfo.InvariantCulture, $"{grip.X:R},{grip.Y:R}"));

    public void GripDropped(Point2D place) => _ = desk.Queue.PointAsync(place, GripEdit);

    public void ZoomExtents() => _ = desk.Queue.RunAsync("ZOOM", "Extents");

    public void Menu(Point2D place)
    {
        var objects = desk.Prompt.PointRequest is { Purpose: PointPurpose.Object };
        if (desk.Prompt.Command is not null && (objects || desk.Prompt.Options.Count == 0)) _ = desk.Queue.EnterAsync("");
        else menu();
    }

    /// <summary>Shift at "Select objects": removes what is at the point, or starts a box for removing, and then adds objects again.</summary>
    private async Task RemoveAsync(Point2D place)
    {
        if (desk.Prompt.Options.All(option => option.Name != "Remove")) return;
        _returnsToAdding = true;
        await desk.Queue.EnterAsync("Remove");
        await GiveAsync(place);
    }

    private async Task GiveAsync(Point2D place)
    {
        await desk.Queue.PointAsync(place);
        if (!_returnsToAdding || Aim is { Purpose: PointPurpose.Corner }) return;
        _returnsToAdding = false;
        if (Aim is { Purpose: PointPurpose.Object, IsDeselecting: true }) await desk.Queue.EnterAsync("Add");
    }

    public void CursorAt(Point2D? place)
    {
        desk.Cursor = place;
        if (place is { } at) pointed(at);
    }
}
