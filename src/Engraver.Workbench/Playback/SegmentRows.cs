using Engraver.Core.EntityTables;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing;

namespace Engraver.Workbench.Playback;

/// <summary>Which row of the sequenced table each segment of the motion program engraves.</summary>
/// <remarks>A row may become several segments (a spline, an arc that is split) or none (shorter than a count). Both sides keep their order, so one walk through both is enough.</remarks>
internal static class SegmentRows
{
    /// <summary>Counts by which a segment's predicted end may stand beside the end of its row.</summary>
    private const double Near = 2.0;

    public static int[] Map(MotionProgram program, SequencingResult sequence)
    {
        var rows = new int[program.SegmentCount];
        var firstRows = FirstRows(sequence);
        var at = 0;
        foreach (var stroke in program.Strokes)
        {
            var walk = new Walk(sequence.Table, program.Profile.Scale, firstRows[stroke.Index], firstRows[stroke.Index + 1]);
            for (var part = 0; part < stroke.Sequences.Count; part++)
            {
                var segments = stroke.Sequences[part].Segments;
                for (var i = 0; i < segments.Count; i++) rows[at++] = walk.Take(segments[i]);
            }
        }

        return rows;
    }

    /// <summary>The table holds the rows of stroke 0, then of stroke 1 ...; a place more than there are strokes.</summary>
    private static int[] FirstRows(SequencingResult sequence)
    {
        var first = new int[sequence.Strokes.Count + 1];
        for (var stroke = 0; stroke < sequence.Strokes.Count; stroke++) first[stroke + 1] = first[stroke] + sequence.Strokes[stroke].Moves.Count;
        return first;
    }

    private sealed class Walk(EntityTable table, CountsScale scale, int row, int end)
    {
        private bool _rowIsDone;

        public int Take(in VectorSegment segment)
        {
            if (_rowIsDone && row + 1 < end) row++;
            while (table.EntityIndexOf(row) != segment.EntityIndex && row + 1 < end) row++;
            var exact = scale.Exact(table[row].EndPoint);
            _rowIsDone = Math.Abs(exact.X - segment.End.X) <= Near && Math.Abs(exact.Y - segment.End.Y) <= Near;
            return row;
        }
    }
}
