using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>Distances that the tool travels between strokes, millimetres.</summary>
internal static class TravelDistance
{
    public static double Through(Point2D toolStart, IReadOnlyList<SequencedStroke> strokes)
    {
        var (tool, travel) = (toolStart, 0.0);
        foreach (var stroke in strokes)
        {
            travel += tool.DistanceTo(stroke.Start);
            tool = stroke.End;
        }

        return travel;
    }

    /// <summary>Travel with every DXF curve as a separate stroke: successive rows of one entity are one curve.</summary>
    public static double AsDrawn(Point2D toolStart, EntityTable analysed)
    {
        var (tool, travel) = (toolStart, 0.0);
        for (var row = 0; row < analysed.Count; row++)
        {
            if (row == 0 || analysed.EntityIndexOf(row) != analysed.EntityIndexOf(row - 1)) travel += tool.DistanceTo(analysed[row].StartPoint);
            tool = analysed[row].EndPoint;
        }

        return travel;
    }
}
