using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;

namespace Engraver.Core.Toolpaths;

/// <summary>Sequenced strokes to a machine-neutral toolpath.</summary>
public static class ToolpathPlanner
{
    /// <summary>One toolpath stroke for each sequenced stroke, geometry untouched: a gap within the join tolerance stays for motion generation to close.</summary>
    public static Toolpath Plan(SequencingResult sequenced, Point2D toolStart) =>
        new(toolStart, [.. sequenced.Strokes.Select(stroke => new ToolpathStroke(stroke.Index, stroke.Closed, stroke.Moves))]);
}
