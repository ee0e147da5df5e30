using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;

namespace Engraver.Workbench.Playback;

/// <summary>Maps each segment of the motion program to its toolpath move, and each move to its row of the sequenced table.</summary>
/// <remarks>A move may become several segments (an arc that is split) or none (shorter than a count); a row of an ellipse or spline is several
/// moves.</remarks>
internal static class SegmentMoves
{
    /// <summary>For each segment the index of its move in the whole toolpath.</summary>
    /// <param name="path">Source of the program.</param>
    public static int[] Map(MotionProgram program, Toolpath path)
    {
        var moves = new int[program.SegmentCount];
        var firstMoves = FirstMoves(path);
        var at = 0;
        foreach (var stroke in program.Strokes)
        {
            for (var part = 0; part < stroke.Sequences.Count; part++)
            {
                var segments = stroke.Sequences[part].Segments;
                for (var i = 0; i < segments.Count; i++) moves[at++] = firstMoves[stroke.Index] + segments[i].Move;
            }
        }

        return moves;
    }

    /// <summary>For each move of the toolpath its row; null if every row is one move and the numbers are equal.</summary>
    public static int[]? RowsOf(Toolpath path)
    {
        if (path.Strokes.All(stroke => stroke.RowMoves is null)) return null;
        var rows = new int[path.Strokes.Sum(stroke => stroke.Moves.Count)];
        var (move, row) = (0, 0);
        foreach (var stroke in path.Strokes)
        {
            var rowsOfStroke = stroke.RowMoves?.Count ?? stroke.Moves.Count;
            for (var i = 0; i < rowsOfStroke; i++, row++)
            {
                for (var pieces = stroke.RowMoves?[i] ?? 1; pieces > 0; pieces--) rows[move++] = row;
            }
        }

        return rows;
    }

    /// <summary>The moves of stroke 0, then of stroke 1 ...</summary>
    private static int[] FirstMoves(Toolpath path)
    {
        var first = new int[path.Strokes.Count];
        for (var stroke = 1; stroke < first.Length; stroke++) first[stroke] = first[stroke - 1] + path.Strokes[stroke - 1].Moves.Count;
        return first;
    }
}
