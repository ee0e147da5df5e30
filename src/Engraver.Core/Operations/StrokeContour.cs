using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Operations;

/// <summary>What a stroke cuts of the shape of its operation, for the check: without leads, descents and the part that is cut twice, with level sides in the
/// place of slopes and gaps of tabs.</summary>
internal sealed class StrokeContour
{
    private const double LengthRounding = 1e-6;

    /// <summary>Ends of a gap are as near as this to the side on which it is, mm.</summary>
    private const double OnSide = 1e-4;

    private readonly EntityTable _path;

    /// <param name="pieces">The strokes of one pass of one contour, in order.</param>
    public StrokeContour(ShapedOperation shape, IReadOnlyList<ToolpathStroke> pieces)
    {
        _path = shape.Path;
        if (pieces is [var only] && shape.Operation.Overcut == 0.0 && only.Moves.All(move => move.Role == StrokeRole.Cut))
        {
            (Stroke, Overcut) = (only, []);
            return;
        }

        var moves = new List<StrokeMove>();
        foreach (var piece in pieces)
        {
            if (moves.Count > 0) Bridge(moves, piece.Moves[0].Segment.Start);
            foreach (var move in piece.Moves.Where(move => move.Segment.Length > 0.0 && move.Role is StrokeRole.Cut or StrokeRole.Tab && IsLevel(move)))
            {
                if (moves.Count > 0 && (move.Role == StrokeRole.Tab || moves[^1].Role == StrokeRole.Tab)) Bridge(moves, move.Segment.Start);
                moves.Add(move);
            }
        }

        Overcut = Overlapping(moves, shape.Operation.Overcut);
        if (Overcut.Count > 0) moves.RemoveRange(moves.Count - Overcut.Count, Overcut.Count);
        Stroke = pieces[0] with { Moves = moves, RowMoves = null };
    }

    /// <summary>The contour; without a move when nothing is cut.</summary>
    public ToolpathStroke Stroke { get; }

    /// <summary>The moves beyond the start.</summary>
    public IReadOnlyList<StrokeMove> Overcut { get; }

    /// <summary>Lengths of gaps that were closed: slopes, and places where the tool is off.</summary>
    public List<double> Gaps { get; } = [];

    public bool IsClosed => Stroke.Moves.Count > 0 && Stroke.Start.IsNear(Stroke.End, LengthRounding);

    /// <summary>True when what is cut beyond the start is not the stated length of the beginning of the contour.</summary>
    public bool HasOvercutFault(double stated)
    {
        if (stated == 0.0 || Stroke.Moves.Count == 0) return Overcut.Count > 0;
        if (!IsClosed) return Overcut.Count > 0 || Stroke.Moves.Skip(1).Any(move => move.Segment.Start.IsNear(Stroke.Start, LengthRounding));
        if (Math.Abs(Overcut.Sum(move => move.Segment.Length) - Math.Min(stated, Stroke.Length)) > LengthRounding) return true;
        var along = 0.0;
        foreach (var move in Overcut)
        {
            if (move.Role != StrokeRole.Cut || ((double[])[0.0, 0.3, 0.7, 1.0]).Any(part => !move.Segment.PointAt(part).IsNear(PlaceAt(along + (part * move.Segment.Length)), LengthRounding))) return true;
            along += move.Segment.Length;
        }

        return false;
    }

    private static bool IsLevel(in StrokeMove move) => move.StartZ == move.EndZ;

    /// <summary>The last moves of a closed contour whose length is that of the overcut: they begin where the contour begins.</summary>
    private static List<StrokeMove> Overlapping(List<StrokeMove> moves, double stated)
    {
        if (stated == 0.0 || moves.Count == 0) return [];
        var (whole, tail) = (moves.Sum(move => move.Segment.Length), 0.0);
        var wanted = Math.Min(stated, whole / 2.0);
        for (var index = moves.Count - 1; index > 0; index--)
        {
            tail += moves[index].Segment.Length;
            if (Math.Abs(tail - wanted) <= LengthRounding && moves[index].Segment.Start.IsNear(moves[0].Segment.Start, LengthRounding)) return moves[index..];
        }

        return [];
    }

    private Point2D PlaceAt(double along)
    {
        var index = 0;
        for (; index < Stroke.Moves.Count - 1 && along > Stroke.Moves[index].Segment.Length; index++) along -= Stroke.Moves[index].Segment.Length;
        var segment = Stroke.Moves[index].Segment;
        return segment.PointAt(Math.Min(1.0, along / segment.Length));
    }

    /// <summary>Closes a gap by the part of the side on which both of its ends are; a gap that is not on one side remains and is found as one.</summary>
    private void Bridge(List<StrokeMove> moves, Point2D to)
    {
        var from = moves[^1].Segment.End;
        if (from.IsNear(to, LengthRounding)) return;
        for (var row = 0; row < _path.Count; row++)
        {
            var side = _path[row].ToSegment();
            if (side.IsFreeCurve || side.DistanceTo(from) > OnSide || side.DistanceTo(to) > OnSide) continue;
            var bridge = side.Kind == SegmentKind.Line ? Segment.FromLine(from, to) : Segment.FromArc(new ArcSegment(side.Arc.Centre, side.Arc.Radius, (from - side.Arc.Centre).Direction, (from - side.Arc.Centre).TurnTo(to - side.Arc.Centre)), from, to);
            if (side.DistanceTo(bridge.PointAt(0.5)) > OnSide) continue;
            moves.Add(moves[^1] with { Segment = bridge, EntityIndex = _path.EntityIndexOf(row), Role = StrokeRole.Tab });
            Gaps.Add(bridge.Length);
            return;
        }
    }
}
