using Engraver.Core.Diagnostics;
using Engraver.Core.Dxf.Writing;
using Engraver.Core.Geometry;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Posts;

/// <summary>CL data: the sequenced, oriented drawing written as a drawing again, entity by entity in the order of the tool path (paper 000).</summary>
public static class ClData
{
    /// <summary>Layer of strokes that end where they start.</summary>
    public const string ClosedLayer = "CUT_CLOSED";

    /// <summary>Layer of the other strokes.</summary>
    public const string OpenLayer = "CUT_OPEN";

    /// <summary>Layer of the moves with the tool off; it does not plot, so that a program that reads the file does not cut them.</summary>
    public const string RapidLayer = "RAPID";

    private static readonly DxfSheetLayer[] s_layers = [new(ClosedLayer, 4), new(OpenLayer, 30), new(RapidLayer, 1, Plots: false)];

    /// <summary>Writes the path as DXF: each rapid before the stroke it leads to, each stroke's moves in order and direction. An empty path is an empty
    /// drawing.</summary>
    /// <remarks>With the strokes as drawn, an ellipse stays an exact ELLIPSE and a spline an exact SPLINE, while a planned path has arcs within a
    /// tolerance.</remarks>
    /// <param name="sourceOf">The entity of a move in the drawing, for the message of the exception; null for none.</param>
    /// <exception cref="UnwritableEntityException">A number of the path is not finite.</exception>
    public static void Write(Toolpath path, Func<int, SourceRef>? sourceOf, TextWriter output) => DxfWriter.Write(new DxfSheet(s_layers, [.. Entities(path, sourceOf)]), output);

    private static IEnumerable<DxfSheetEntity> Entities(Toolpath path, Func<int, SourceRef>? sourceOf)
    {
        var (tool, sequence) = (path.ToolStart, 0);
        foreach (var stroke in path.Strokes)
        {
            var number = stroke.Index + 1;
            if (tool != stroke.Start) yield return new DxfSheetEntity(Segment.FromLine(tool, stroke.Start), RapidLayer, "rapid", 0, number);
            foreach (var move in stroke.Moves) yield return new DxfSheetEntity(move.Segment, stroke.Closed ? ClosedLayer : OpenLayer, "cut", ++sequence, number) { Source = sourceOf?.Invoke(move.EntityIndex) ?? default };
            tool = stroke.End;
        }
    }
}
