namespace Engraver.Core.Operations;

/// <summary>Order of the passes of an operation.</summary>
public enum PassOrder
{
    /// <summary>All passes of a contour, then the next contour.</summary>
    Contour,

    /// <summary>One pass of all contours, then the next pass.</summary>
    Level,
}
