using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Toolpaths;

/// <summary>Converts sequenced strokes to a machine-neutral toolpath. Ellipses and splines become arcs and lines.</summary>
public static class ToolpathPlanner
{
    /// <summary>One toolpath stroke for each sequenced stroke. Lines, arcs and circles are unchanged (motion generation closes gaps within the join tolerance);
    /// every piece of an ellipse or spline has its entity's index.</summary>
    /// <param name="sequenced">The result of sequencing.</param>
    /// <param name="toolStart">Position of the tool when the job starts, millimetres.</param>
    /// <param name="maxErrorMm">Largest distance of arcs and lines from their ellipse or spline, above 0.</param>
    public static Toolpath Plan(SequencingResult sequenced, Point2D toolStart, double maxErrorMm)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(maxErrorMm);
        return new Toolpath(toolStart, sequenced.Table.HasFreeCurves ? [.. sequenced.Strokes.Select(stroke => Cuttable(stroke, maxErrorMm))] : AreSame(sequenced.Strokes));
    }

    /// <summary>Strokes with unchanged ellipses and splines, for machines that cut them directly.</summary>
    public static Toolpath WithCurves(SequencingResult sequenced, Point2D toolStart) => new(toolStart, AreSame(sequenced.Strokes));

    private static ComputedList<ToolpathStroke> AreSame(IReadOnlyList<SequencedStroke> strokes) => new(strokes.Count, index => AreSame(strokes[index]));

    private static ToolpathStroke AreSame(SequencedStroke stroke) => new(stroke.Index, stroke.Closed, stroke.Moves);

    private static ToolpathStroke Cuttable(SequencedStroke stroke, double maxErrorMm)
    {
        if (!stroke.Moves.Any(move => move.Segment.IsFreeCurve)) return AreSame(stroke);
        var (cuttable, rowMoves) = (new List<StrokeMove>(), new List<int>(stroke.Moves.Count));
        foreach (var move in stroke.Moves)
        {
            var before = cuttable.Count;
            if (!move.Segment.IsFreeCurve) cuttable.Add(move);
            else cuttable.AddRange(BiarcFit.Fit(move.Segment.Curve, maxErrorMm).Select(piece => new StrokeMove(piece, move.EntityIndex, move.StartZ, move.EndZ)));
            rowMoves.Add(cuttable.Count - before);
        }

        return new ToolpathStroke(stroke.Index, stroke.Closed, cuttable) { RowMoves = rowMoves };
    }
}
