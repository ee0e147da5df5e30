using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;

namespace Engraver.Workbench.Playback;

/// <summary>Maps each place on the motion program to its toolpath move, and each move to its row of the sequenced table.</summary>
/// <remarks>A move may become several segments (an arc that is split) or none (shorter than a count); several moves may become one segment; a row of an ellipse
/// or spline is several moves.</remarks>
internal sealed class SegmentMoves
{
    /// <summary>For each segment the move at its start, numbered in the whole toolpath.</summary>
    private readonly int[] _first;

    /// <summary>For a segment of several moves: the fractions of it at which the second one begins, the third one ...</summary>
    private readonly Dictionary<int, double[]> _starts = [];

    /// <summary>Drawing entity of each move.</summary>
    private readonly int[] _entities;

    private SegmentMoves(int segments, Toolpath path) => (_first, _entities) = (new int[segments], [.. path.Strokes.SelectMany(stroke => stroke.Moves).Select(move => move.EntityIndex)]);

    public int Count => _first.Length;

    /// <param name="path">Source of the program.</param>
    public static SegmentMoves Map(MotionProgram program, Toolpath path)
    {
        var moves = new SegmentMoves(program.SegmentCount, path);
        var firstMoves = FirstMoves(path);
        var at = 0;
        foreach (var stroke in program.Strokes)
        {
            List<VectorSegment> merged = [];
            foreach (var segment in stroke.Sequences.SelectMany(sequence => sequence.Segments))
            {
                if (merged.Count > 0 && (segment.Move, segment.Moves) != (merged[0].Move, merged[0].Moves)) moves.AddMerged(merged, ref at, path.Strokes[stroke.Index], firstMoves[stroke.Index]);
                if (segment.Moves > 1) merged.Add(segment);
                else moves._first[at++] = firstMoves[stroke.Index] + segment.Move;
            }

            if (merged.Count > 0) moves.AddMerged(merged, ref at, path.Strokes[stroke.Index], firstMoves[stroke.Index]);
        }

        return moves;
    }

    /// <summary>The move at the start of a segment.</summary>
    public int FirstOf(int segment) => _first[segment];

    /// <summary>The move at the end of a segment.</summary>
    public int LastOf(int segment) => _first[segment] + (_starts.TryGetValue(segment, out var starts) ? starts.Length : 0);

    /// <summary>The drawing entity of a move.</summary>
    public int EntityOf(int move) => _entities[move];

    /// <summary>The move at a fraction of a segment.</summary>
    public int At(int segment, double fraction)
    {
        var move = _first[segment];
        if (!_starts.TryGetValue(segment, out var starts)) return move;
        var found = Array.BinarySearch(starts, fraction);
        return move + (found >= 0 ? found + 1 : ~found);
    }

    /// <summary>The fraction of a segment at which one of its moves begins; 0 for the first.</summary>
    public double StartOf(int segment, int move) => move > _first[segment] && _starts.TryGetValue(segment, out var starts) ? starts[move - _first[segment] - 1] : 0.0;

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

    /// <summary>The segments of one path of several moves: their lengths are in proportion.</summary>
    private void AddMerged(List<VectorSegment> merged, ref int at, ToolpathStroke stroke, int firstMove)
    {
        var (first, count) = (merged[0].Move, merged[0].Moves);
        var ends = new double[count];
        for (var i = 0; i < count; i++) ends[i] = (i == 0 ? 0.0 : ends[i - 1]) + stroke.Moves[first + i].Segment.Length;
        var (whole, reached, move) = (merged.Sum(segment => segment.Length), 0.0, 0);
        foreach (var segment in merged)
        {
            var (from, to) = (reached / whole * ends[^1], (reached + segment.Length) / whole * ends[^1]);
            _first[at] = firstMove + first + move;
            var starts = new List<double>();
            for (; move + 1 < count && ends[move] < to; move++) starts.Add((ends[move] - from) / (to - from));
            if (starts.Count > 0) _starts[at] = [.. starts];
            reached += segment.Length;
            at++;
        }

        merged.Clear();
    }

    /// <summary>The moves of stroke 0, then of stroke 1 ...</summary>
    private static int[] FirstMoves(Toolpath path)
    {
        var first = new int[path.Strokes.Count];
        for (var stroke = 1; stroke < first.Length; stroke++) first[stroke] = first[stroke - 1] + path.Strokes[stroke - 1].Moves.Count;
        return first;
    }
}
