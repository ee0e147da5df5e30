using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Plots;

/// <summary>Content of a picture of a drawing or a path, in millimetres and independent of the picture format.</summary>
/// <param name="Title">Caption: usually the file name.</param>
/// <param name="Strokes">Curves, in the order of cutting if there is one.</param>
/// <param name="Rapids">Travel with the tool off, in order.</param>
/// <param name="ToolStart">Position of the tool at the start; null in a picture of the drawing alone.</param>
public sealed record PlotModel(string Title, IReadOnlyList<PlotStroke> Strokes, IReadOnlyList<LineSegment> Rapids, Point2D? ToolStart)
{
    /// <summary>Smallest box of the curves, without travel; empty when nothing is drawn.</summary>
    public Bounds2D DrawnBounds => Strokes.SelectMany(stroke => stroke.Segments).Aggregate(Bounds2D.Empty, (box, segment) => box.Union(segment.Bounds));

    /// <summary>Box of all shown elements, including the tool's start.</summary>
    public Bounds2D VisibleBounds => ToolStart is { } start ? DrawnBounds.Including(start) : DrawnBounds;

    /// <summary>Meaning of the colours of a run; null in a picture of a drawing or a path.</summary>
    public PlotHeat? Heat { get; init; }

    /// <summary>Points and corners of trajectories; none in other pictures.</summary>
    public IReadOnlyList<PlotMark> Marks { get; init; } = [];

    public double CutLength => Strokes.Sum(stroke => stroke.Length);

    public double Travel => Rapids.Sum(rapid => rapid.Length);

    /// <summary>The drawing as in the file: one curve for each run of rows of one entity, no order.</summary>
    public static PlotModel FromDrawing(EntityTable analysed, string title)
    {
        var strokes = new List<PlotStroke>();
        for (var row = 0; row < analysed.Count;)
        {
            var segments = new List<Segment>();
            var entity = analysed.EntityIndexOf(row);
            while (row < analysed.Count && analysed.EntityIndexOf(row) == entity) segments.Add(analysed[row++].ToSegment());
            strokes.Add(new PlotStroke(segments, segments[0].Start == segments[^1].End, null));
        }

        return new PlotModel(title, strokes, [], null);
    }

    /// <summary>The path in the order of cutting, with numbers and travel.</summary>
    public static PlotModel FromPath(Toolpath path, string title)
    {
        var rapids = new List<LineSegment>();
        var tool = path.ToolStart;
        foreach (var stroke in path.Strokes)
        {
            if (tool != stroke.Start) rapids.Add(new LineSegment(tool, stroke.Start));
            tool = stroke.End;
        }

        return new PlotModel(title, [.. path.Strokes.Select(ToPlot)], rapids, path.ToolStart);
    }

    private static PlotStroke ToPlot(ToolpathStroke stroke) => new([.. stroke.Moves.Select(move => move.Segment)], stroke.Closed, stroke.Index + 1);
}

/// <summary>A place of a trajectory.</summary>
/// <param name="IsCorner">True for a sharp turn of the contour that it follows; otherwise a point that it visits.</param>
public readonly record struct PlotMark(Point2D Place, bool IsCorner);
