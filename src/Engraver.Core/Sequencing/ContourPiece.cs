using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>One segment of a contour: which row it is, and whether the contour runs it backwards.</summary>
public readonly record struct ContourPiece(int Row, bool Reversed)
{
    /// <summary>The piece when the whole contour is turned round.</summary>
    public ContourPiece Turned() => this with { Reversed = !Reversed };

    public Point2D StartIn(ReadOnlySpan<Segment> segments) => Reversed ? segments[Row].End : segments[Row].Start;

    public Point2D EndIn(ReadOnlySpan<Segment> segments) => Reversed ? segments[Row].Start : segments[Row].End;
}
