using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Toolpaths;

/// <summary>Sequenced strokes to a machine-neutral toolpath. Here, and nowhere earlier, ellipses and splines become arcs and lines.</summary>
public static class ToolpathPlanner
{
    /// <summary>One toolpath stroke for each sequenced stroke. Lines, arcs and circles are untouched (a gap within the join tolerance stays for motion generation to close); of an ellipse or spline every piece carries its entity.</summary>
    /// <param name="sequenced">What sequencing returned.</param>
    /// <param name="toolStart">Where the tool stands when the job starts, millimetres.</param>
    /// <param name="maxErrorMm">How far arcs and lines may leave an ellipse or spline, above 0.</param>
    public static Toolpath Plan(SequencingResult sequenced, Point2D toolStart, double maxErrorMm)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(maxErrorMm);
        var hasCurves = sequenced.Table.HasFreeCurves;
        return new Toolpath(toolStart, [.. sequenced.Strokes.Select(stroke => new ToolpathStroke(stroke.Index, stroke.Closed, hasCurves ? Cuttable(stroke.Moves, maxErrorMm) : stroke.Moves))]);
    }

    private static IReadOnlyList<StrokeMove> Cuttable(IReadOnlyList<StrokeMove> moves, double maxErrorMm)
    {
        if (!moves.Any(move => move.Segment.IsFreeCurve)) return moves;
        var cuttable = new List<StrokeMove>();
        foreach (var move in moves)
        {
            if (!move.Segment.IsFreeCurve) cuttable.Add(move);
            else cuttable.AddRange(BiarcFit.Fit(move.Segment.Curve, maxErrorMm).Select(piece => new StrokeMove(piece, move.EntityIndex)));
        }

        return cuttable;
    }
}
