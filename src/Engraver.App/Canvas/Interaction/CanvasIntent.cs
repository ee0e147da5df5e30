using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Interaction;

/// <summary>What a movement of the mouse or a key means. Places are pixels of the canvas.</summary>
internal abstract record CanvasIntent
{
    private CanvasIntent()
    {
    }

    public static CanvasIntent None { get; } = new Nothing();

    public sealed record Nothing : CanvasIntent;

    /// <summary>The drawing goes with the hand by so many pixels.</summary>
    public sealed record Pan(Vector2D By) : CanvasIntent;

    /// <summary>Larger (factor above 1) or smaller, the place under the cursor staying.</summary>
    public sealed record Zoom(Point2D About, double Factor) : CanvasIntent;

    public sealed record ZoomExtents : CanvasIntent;

    /// <summary>Selects what is under the pickbox, or takes it out of the selection.</summary>
    public sealed record Pick(Point2D At, bool Remove) : CanvasIntent;

    /// <summary>Selects what is in the box, or takes it out of the selection.</summary>
    public sealed record Select(SelectionBox Box, bool Remove) : CanvasIntent;

    /// <summary>The point that a command asked for.</summary>
    public sealed record GivePoint(Point2D At) : CanvasIntent;

    /// <summary>Clicked twice: a finding comes near.</summary>
    public sealed record Open(Point2D At) : CanvasIntent;

    /// <summary>The cursor stands here.</summary>
    public sealed record Hover(Point2D At) : CanvasIntent;

    /// <summary>Enter, as a click with the right button means to a command that runs, or a menu.</summary>
    public sealed record Menu(Point2D At) : CanvasIntent;

    /// <summary>Esc with nothing of the canvas's own to end: the command, then the selection.</summary>
    public sealed record Cancel : CanvasIntent;
}
