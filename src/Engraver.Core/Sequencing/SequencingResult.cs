using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;

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
