namespace Engraver.Core.Sequencing.Ordering;

/// <summary>Orders of strokes. In each order, an inner stroke comes before the enclosing stroke.</summary>
public enum StrokeOrder
{
    /// <summary>File order of each contour's lowest row, drawn directions and start points.</summary>
    Drawn,

    /// <summary>Always the nearest next start; contours start at the point nearest to the tool.</summary>
    Nearest,

    /// <summary>The order of the least travel that a search finds, with the starts and directions of the contours.</summary>
    Optimal,
}
