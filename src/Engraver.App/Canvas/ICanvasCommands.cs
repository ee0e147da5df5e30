using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Canvas;

/// <summary>Receives what the operator does on the canvas and converts it to inputs of the command session. Drawing units.</summary>
public interface ICanvasCommands
{
    /// <summary>The kind of point that the running command requests: clicks then give points instead of selecting; null if no point is requested.</summary>
    PointRequest? Aim { get; }

    /// <summary>The result of Enter, independent of the cursor; null if there is no preview.</summary>
    GhostFunction? Preview { get; }

    /// <summary>The instruction of the active prompt.</summary>
    string Instruction { get; }

    /// <summary>Selects what is under the pickbox.</summary>
    /// <param name="entity">The nearest entity.</param>
    /// <param name="shown">The drawing that the canvas shows; the index of the entity refers to it.</param>
    /// <param name="remove">Removes it from the selection (Shift).</param>
    void PickAt(Point2D place, int entity, Drawing shown, bool remove);

    /// <summary>Selects by a box between two corners.</summary>
    /// <param name="crossing">Selects what touches the box, not only what is inside.</param>
    /// <param name="remove">Removes it from the selection (Shift).</param>
    void SelectBox(Point2D from, Point2D to, bool crossing, bool remove);

    /// <summary>Esc: ends the command, or clears the selection if no command is active.</summary>
    void Cancel();

    /// <summary>The point that a command requested, snapped if a snap was found.</summary>
    /// <param name="remove">Removes what is at the point from the picked objects, or inverts the operation of the command (Shift).</param>
    void PointGiven(Point2D place, bool remove);

    /// <summary>A grip of the selection was pressed; it is dragged from now on.</summary>
    void GripPressed(Point2D grip);

    /// <summary>The grip that was dragged was released.</summary>
    void GripDropped(Point2D place);

    /// <summary>Shows the whole drawing.</summary>
    void ZoomExtents();

    /// <summary>The right button: a menu, or Enter for a command that requests objects or has no options.</summary>
    void Menu(Point2D place);

    /// <summary>The cursor has moved to a point; null when it has left the canvas.</summary>
    void CursorAt(Point2D? place);
}
