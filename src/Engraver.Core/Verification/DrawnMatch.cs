using System.Numerics;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Verification;

/// <summary>Pairs unchanged moves of a toolpath (lines, arcs, circles; for CL data also curves) with their rows, by entity and exact ends; each row once. In
/// linear time.</summary>
/// <param name="Rows">Rows without a move: ellipses and splines that became arcs, duplicates, lines replaced by an arc, and missing ones.</param>
/// <param name="Moves">Moves without a row: those that replace such rows, and superfluous ones.</param>
internal sealed record DrawnMatch(IReadOnlyList<StrokeMove> Rows, IReadOnlyList<StrokeMove> Moves)
{
    /// <param name="drawn">The table as drawn.</param>
    /// <param name="toolpath">The toolpath of the table.</param>
    /// <param name="joint">Called for every pair of consecutive moves of a stroke, with the earlier move first.</param>
    public static DrawnMatch From(EntityTable drawn, Toolpath toolpath, Joint joint)
    {
        var pairs = new RowsByPair(drawn);
        var rows = new List<StrokeMove>();
        var moves = new List<StrokeMove>();
        var paired = new bool[drawn.Count];
        foreach (var stroke in toolpath.Strokes)
        {
            var before = default(StrokeMove?);
            foreach (var move in stroke.Moves)
            {
                if (before is { } last) joint(last, move);
                before = move;
                if (!Pair(drawn, move, pairs, paired)) moves.Add(move);
            }
        }

        for (var row = 0; row < drawn.Count; row++)
        {
            if (!paired[row]) rows.Add(new StrokeMove(drawn[row].ToSegment(), drawn.EntityIndexOf(row)));
        }

        return new DrawnMatch(rows, moves);
    }

    /// <summary>Two consecutive moves of a stroke.</summary>
    public delegate void Joint(in StrokeMove last, in StrokeMove move);

    private static bool Pair(EntityTable drawn, in StrokeMove move, RowsByPair pairs, bool[] paired)
    {
        var key = PairKey.From(move.Segment, move.EntityIndex);
        for (var row = pairs.Last(key); row >= 0; row = pairs.Before(row, key))
        {
            if (paired[row] || !AreSame(drawn, row, move.Segment)) continue;
            return paired[row] = true;
        }

        return false;
    }

    /// <summary>For segments with the same ends: lines and circles are then the same, arcs if they also have the same middle, curves if all spans are
    /// equal.</summary>
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

    /// <summary>Both ends in an order that does not depend on the direction; for a circle its centre and radius.</summary>
    private readonly record struct PairKey(int Entity, SegmentKind Kind, double X1, double Y1, double X2, double Y2)
    {
        public static PairKey From(in EntityRow row) => row.Kind == SegmentKind.Line ? From(row.StartPoint, row.EndPoint, SegmentKind.Line, row.EntityIndex) : From(row.ToSegment(), row.EntityIndex);

        public static PairKey From(in Segment segment, int entity)
        {
            if (segment.Kind == SegmentKind.Circle) return new PairKey(entity, segment.Kind, segment.Arc.Centre.X, segment.Arc.Centre.Y, segment.Arc.Radius, 0.0);
            return From(segment.Start, segment.End, segment.Kind, entity);
        }

        private static PairKey From(Point2D a, Point2D b, SegmentKind kind, int entity) =>
            a.X < b.X || (a.X == b.X && a.Y <= b.Y) ? new PairKey(entity, kind, a.X, a.Y, b.X, b.Y) : new PairKey(entity, kind, b.X, b.Y, a.X, a.Y);
    }

    /// <summary>The rows of a table by their pair, the last first: chains of rows with the same hash, whose keys are read from the rows. An entity with few
    /// rows has its own chain, without hashing.</summary>
    private sealed class RowsByPair
    {
        private const int None = -1;

        /// <summary>The rows of an entity are found by their hash.</summary>
        private const int Hashed = -2;
        private const int FewRows = 8;
        private readonly EntityTable _drawn;

        /// <summary>The last row of each entity; <see cref="Hashed"/> for an entity with many rows.</summary>
        private readonly int[] _lastOf;
        private readonly int[] _heads;
        private readonly int[] _next;

        public RowsByPair(EntityTable drawn)
        {
            _drawn = drawn;
            var rowsOf = RowsOfEntities(drawn);
            _lastOf = [.. rowsOf.Select(count => count > FewRows ? Hashed : None)];
            _heads = new int[BitOperations.RoundUpToPowerOf2((uint)Math.Max(16, rowsOf.Where(count => count > FewRows).Sum()))];
            _next = new int[drawn.Count];
            Array.Fill(_heads, None);
            for (var row = 0; row < drawn.Count; row++)
            {
                ref var last = ref _lastOf[drawn.EntityIndexOf(row)];
                ref var head = ref last != Hashed ? ref last : ref _heads[BucketOf(KeyOf(row))];
                (_next[row], head) = (head, row);
            }
        }

        public int Last(in PairKey key)
        {
            if ((uint)key.Entity >= (uint)_lastOf.Length) return None;
            var last = _lastOf[key.Entity];
            return FirstOf(last != Hashed ? last : _heads[BucketOf(key)], key);
        }

        public int Before(int row, in PairKey key) => FirstOf(_next[row], key);

        private static int[] RowsOfEntities(EntityTable drawn)
        {
            var most = -1;
            for (var row = 0; row < drawn.Count; row++) most = Math.Max(most, drawn.EntityIndexOf(row));
            var rows = new int[most + 1];
            for (var row = 0; row < drawn.Count; row++) rows[drawn.EntityIndexOf(row)]++;
            return rows;
        }

        private int FirstOf(int row, in PairKey key)
        {
            while (row >= 0 && KeyOf(row) != key) row = _next[row];
            return row;
        }

        private PairKey KeyOf(int row) => PairKey.From(_drawn[row]);

        private int BucketOf(in PairKey key) => (int)(((uint)key.GetHashCode() * 0x9E3779B97F4A7C15UL) >> 32) & (_heads.Length - 1);
    }
}
