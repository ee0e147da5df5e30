using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing;

/// <summary>Strokes in the order of cutting, with every figure of the <c>sequence</c> object of the command line. Lengths in millimetres.</summary>
public sealed record SequencingResult
{
    public required IReadOnlyList<SequencedStroke> Strokes { get; init; }

    /// <summary>Every end of every open stroke.</summary>
    public required OpenEndList Discontinuities { get; init; }

    /// <summary>The rows in sequence order, slot 13 = 1..n, reversed rows and circles rewritten.</summary>
    public required EntityTable Table { get; init; }

    /// <summary>Lines, arcs, circles, ellipses and splines, each counted as one.</summary>
    public required int Segments { get; init; }

    /// <summary>Rows that are cut against their drawn direction.</summary>
    public required int Reversed { get; init; }

    public required int DuplicatesRemoved { get; init; }

    public required double PathLength { get; init; }

    /// <summary>Rapid distance from the tool start through every stroke in order.</summary>
    public required double Travel { get; init; }

    /// <summary><see cref="Travel"/> plus the return to the tool start.</summary>
    public required double TravelAndBack { get; init; }

    /// <summary>The rapid distance if every DXF curve were a separate stroke, in file order and drawn direction, duplicates included.</summary>
    public required double TravelAsDrawn { get; init; }

    public required IReadOnlyList<Diagnostic> Diagnostics { get; init; }

    public int Contours => Strokes.Count;

    public int Closed => Strokes.Count(stroke => stroke.Closed);

    public int Open => Contours - Closed;
}

/// <summary>One contour at its position in the order of cutting, with its direction and start point.</summary>
/// <param name="Index">0 is cut first.</param>
/// <param name="Closed">True when it ends where it starts (within the join tolerance).</param>
/// <param name="Moves">Segments in order and direction, read from the sequenced table.</param>
/// <param name="Segments">Lines, arcs, circles, ellipses and splines in it, each counted as one.</param>
/// <param name="Length">Length along the path, millimetres.</param>
/// <param name="Inside">Index of the closed stroke that directly encloses this one, -1 for none; always greater than <paramref name="Index"/>.</param>
public sealed record SequencedStroke(int Index, bool Closed, IReadOnlyList<StrokeMove> Moves, int Segments, double Length, int Inside)
{
    public Point2D Start => Moves[0].Segment.Start;

    public Point2D End => Moves[^1].Segment.End;
}
