using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Workbench.Playback;

/// <summary>Maps each segment of the motion program to its toolpath move, and each move to its row of the sequenced table.</summary>
/// <remarks>A move may become several segments (an arc that is split) or none (shorter than a count); a row of an ellipse or spline is several moves. Both have
/// the same order, so one pass over both is sufficient.</remarks>
internal static class SegmentMoves
{
    /// <summary>Tolerance between the predicted end of a segment and the end of its move, counts.</summary>
    private const double Near = 2.0;

    /// <summary>For each segment the index of its move in the whole toolpath.</summary>
    /// <param name="path">Source of the program.</param>
    public static int[] Map(MotionProgram program, Toolpath path)
    {
        var moves = new int[program.SegmentCount];
        var firstMoves = FirstMoves(path);
        var at = 0;
        foreach (var stroke in program.Strokes)
        {
            var walk = new MoveCursor(path.Strokes[stroke.Index].Moves, program.Profile.Scale);
            for (var part = 0; part < stroke.Sequences.Count; part++)
            {
                var segments = stroke.Sequences[part].Segments;
                for (var i = 0; i < segments.Count; i++) moves[at++] = firstMoves[stroke.Index] + walk.Advance(segments[i]);
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

    private sealed class MoveCursor
    {
        private readonly IReadOnlyList<StrokeMove> _moves;
        private readonly CountsScale _scale;
        private int _at;
        private bool _isDone;

        /// <summary>The cached move at <see cref="_at"/> and its end in counts.</summary>
        private StrokeMove _move;
        private Point2D _end;

        public MoveCursor(IReadOnlyList<StrokeMove> moves, CountsScale scale)
        {
            (_moves, _scale) = (moves, scale);
            GoTo(0);
        }

        public int Advance(in VectorSegment segment)
        {
            if (_isDone && _at + 1 < _moves.Count) GoTo(_at + 1);
            while (_at + 1 < _moves.Count && (_move.EntityIndex != segment.EntityIndex || (!EndsWith(segment) && IsShort()))) GoTo(_at + 1);
            _isDone = EndsWith(segment);
            return _at;
        }

        private void GoTo(int move)
        {
            (_at, _move) = (move, _moves[move]);
            _end = _scale.Exact(_move.Segment.End);
        }

        /// <summary>True if shorter than a count, so that it may have no segment.</summary>
        private bool IsShort() => _scale.Finer.CountsOf(_move.Segment.Length) < 1.0;

        private bool EndsWith(in VectorSegment segment) => Math.Abs(_end.X - segment.End.X) <= Near && Math.Abs(_end.Y - segment.End.Y) <= Near;
    }
}
