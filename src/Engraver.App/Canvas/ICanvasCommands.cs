using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Canvas;

/// <summary>Takes what the operator does on the canvas and turns it into inputs of the command session. Drawing units.</summary>
public interface ICanvasCommands
{
    /// <summary>What the running command wants to be pointed at: clicks then give points and pick nothing; null when none asks.</summary>
    PointAim? Aim { get; }

    /// <summary>What Enter would lead to, wherever the cursor is; null when there is nothing to be seen.</summary>
    GhostOf? Preview { get; }

    /// <summary>The instruction of the command that asks.</summary>
    string Asked { get; }

    /// <summary>Select what lies under the pickbox.</summary>
    /// <param name="entity">The nearest entity there.</param>
    /// <param name="shown">The drawing that the canvas shows, in which the entity is counted.</param>
    /// <param name="remove">Take it out of the selection (Shift).</param>
    void PickAt(Point2D place, int entity, Drawing shown, bool remove);

    /// <summary>Select by a box between two corners.</summary>
    /// <param name="crossing">Whatever touches it, not only what lies inside.</param>
    /// <param name="remove">Take it out of the selection (Shift).</param>
    void SelectBox(Point2D from, Point2D to, bool crossing, bool remove);

    /// <summary>Esc: end the command, or with none clear the selection.</summary>
    void Cancel();

    /// <summary>The point that a command asked for, snapped where a snap stood.</summary>
    /// <param name="remove">What is there is to be taken out of what was picked, or the opposite is to be done (Shift).</param>
    void PointGiven(Point2D place, bool remove);

    /// <summary>A grip of what is selected was pressed: it is dragged from now on.</summary>
    void GripHeld(Point2D grip);

    /// <summary>The grip that was held was let go.</summary>
    void GripDropped(Point2D place);

    /// <summary>Show everything.</summary>
    void ZoomExtents();

    /// <summary>The right button: a menu, or Enter for a command that asks for objects or has no options.</summary>
    void Menu(Point2D place);

    /// <summary>The cursor stands here; null when it has left the canvas.</summary>
    void CursorAt(Point2D? place);
}
