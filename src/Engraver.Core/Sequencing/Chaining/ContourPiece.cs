using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>One segment of a contour: its row, and true when the contour runs it backwards.</summary>
public readonly record struct ContourPiece(int Row, bool Reversed)
{
    /// <summary>Number of the end at which the contour enters the piece: 2 x row is a segment's start, 2 x row + 1 its end.</summary>
    public int StartNumber => (2 * Row) + (Reversed ? 1 : 0);

    /// <summary>Number of the end at which the contour leaves it.</summary>
    public int EndNumber => (2 * Row) + (Reversed ? 0 : 1);

    /// <summary>The piece when the whole contour is reversed.</summary>
    public ContourPiece Turned() => this with { Reversed = !Reversed };

    public Point2D StartIn(ReadOnlySpan<Segment> segments) => Reversed ? segments[Row].End : segments[Row].Start;

    public Point2D EndIn(ReadOnlySpan<Segment> segments) => Reversed ? segments[Row].Start : segments[Row].End;
}
