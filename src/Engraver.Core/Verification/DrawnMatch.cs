using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Verification;

/// <summary>Pairs unchanged moves of a toolpath (lines, arcs, circles; in CL data curves too) with their rows, by entity and exact ends; each row once. In linear time.</summary>
/// <param name="Rows">Rows without a move: ellipses and splines that became arcs, duplicates, lines replaced by an arc, and missing ones.</param>
/// <param name="Moves">Moves without a row: what replaces those rows, and superfluous ones.</param>
internal sealed record DrawnMatch(IReadOnlyList<StrokeMove> Rows, IReadOnlyList<StrokeMove> Moves)
{
    public static DrawnMatch From(EntityTable drawn, Toolpath toolpath)
    {
        var last = new Dictionary<PairKey, int>(drawn.Count);
        var before = new int[drawn.Count];
        var rows = new List<StrokeMove>();
        for (var row = 0; row < drawn.Count; row++)
        {
            before[row] = -1;
            var key = PairKey.From(drawn[row].ToSegment(), drawn.EntityIndexOf(row));
            if (!last.TryAdd(key, row)) (before[row], last[key]) = (last[key], row);
        }

        var moves = new List<StrokeMove>();
        var paired = new bool[drawn.Count];
        foreach (var stroke in toolpath.Strokes)
        {
            foreach (var move in stroke.Moves)
            {
                if (!Pair(drawn, move, last, before, paired)) moves.Add(move);
            }
        }

        for (var row = 0; row < drawn.Count; row++)
        {
            if (!paired[row]) rows.Add(new StrokeMove(drawn[row].ToSegment(), drawn.EntityIndexOf(row)));
        }

        return new DrawnMatch(rows, moves);
    }

    private static bool Pair(EntityTable drawn, in StrokeMove move, Dictionary<PairKey, int> last, int[] before, bool[] paired)
    {
        if (!last.TryGetValue(PairKey.From(move.Segment, move.EntityIndex), out var row)) return false;
        while (row >= 0 && (paired[row] || !AreSame(drawn, row, move.Segment))) row = before[row];
        if (row >= 0) paired[row] = true;
        return row >= 0;
    }

    /// <summary>For segments with the same ends: lines and circles are then the same, arcs when they also have the same middle, curves when all spans are.</summary>
    private static bool AreSame(EntityTable drawn, int row, in Segment cut)
    {
        if (cut.IsFreeCurve) return AreSame(drawn.CurveOf(row)!, cut.Curve);
        if (cut.Kind != SegmentKind.Arc) return true;
        var arc = drawn[row].ToSegment();
        return arc.PointAt(0.5).IsNear(cut.PointAt(0.5), ToolpathTolerances.RoundingOf(arc));
    }

    /// <summary>Compares span by span, in either direction.</summary>
    private static bool AreSame(RationalCurve drawn, RationalCurve cut)
    {
        if (ReferenceEquals(drawn, cut)) return true;
        if (drawn.Spans.Length != cut.Spans.Length) return false;
        return HaveSameSpans(drawn, cut) || HaveSameSpans(drawn, cut.Reversed());
    }

    private static bool HaveSameSpans(RationalCurve drawn, RationalCurve cut)
    {
        for (var i = 0; i < drawn.Spans.Length; i++)
        {
            if (!drawn.Spans[i].Homogeneous.SequenceEqual(cut.Spans[i].Homogeneous)) return false;
        }

        return true;
    }

    /// <summary>Both ends in an order that does not depend on the direction; of a circle its centre and radius.</summary>
    private readonly record struct PairKey(int Entity, SegmentKind Kind, double X1, double Y1, double X2, double Y2)
    {
        public static PairKey From(in Segment segment, int entity)
        {
            if (segment.Kind == SegmentKind.Circle) return new PairKey(entity, segment.Kind, segment.Arc.Centre.X, segment.Arc.Centre.Y, segment.Arc.Radius, 0.0);
            var (a, b) = (segment.Start, segment.End);
            return a.X < b.X || (a.X == b.X && a.Y <= b.Y) ? new PairKey(entity, segment.Kind, a.X, a.Y, b.X, b.Y) : new PairKey(entity, segment.Kind, b.X, b.Y, a.X, a.Y);
        }
    }
}
