using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Interaction;

/// <summary>What a mouse event or a key means on the canvas. Points are in pixels of the canvas.</summary>
internal abstract record CanvasIntent
{
    private CanvasIntent()
    {
    }

    public static CanvasIntent None { get; } = new NoAction();

    public sealed record NoAction : CanvasIntent;

    /// <summary>Moves the drawing by a number of pixels.</summary>
    public sealed record Pan(Vector2D By) : CanvasIntent;

    /// <summary>Enlarges (factor above 1) or shrinks the view around the point under the cursor.</summary>
    public sealed record Zoom(Point2D About, double Factor) : CanvasIntent;

    public sealed record ZoomExtents : CanvasIntent;

    /// <summary>Selects what is under the pickbox, or removes it from the selection.</summary>
    public sealed record Pick(Point2D At, bool Remove) : CanvasIntent;

    /// <summary>Selects what is in the box, or removes it from the selection.</summary>
    public sealed record Select(SelectionBox Box, bool Remove) : CanvasIntent;

    /// <summary>The point that a command requested; with Shift, what is there is removed.</summary>
    public sealed record SubmitPoint(Point2D At, bool Remove = false) : CanvasIntent;

    /// <summary>Starts dragging the grip at the point.</summary>
    public sealed record GrabGrip(Point2D At) : CanvasIntent;

    /// <summary>Ends dragging a grip at the point.</summary>
    public sealed record DropGrip(Point2D At) : CanvasIntent;

    /// <summary>Double click: centres the finding at the point and zooms in.</summary>
    public sealed record Open(Point2D At) : CanvasIntent;

    /// <summary>The cursor has moved to a point.</summary>
    public sealed record Hover(Point2D At) : CanvasIntent;

    /// <summary>Click with the right button: Enter for a running command, otherwise the menu.</summary>
    public sealed record Menu(Point2D At) : CanvasIntent;

    /// <summary>Esc while no box is drawn: ends the command, or clears the selection.</summary>
    public sealed record Cancel : CanvasIntent;
}
