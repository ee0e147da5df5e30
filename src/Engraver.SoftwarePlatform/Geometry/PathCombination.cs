using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Geometry;

/// <summary>Union, intersection, exclusive or and difference of two filled paths, as the outline of the result.</summary>
/// <remarks>Between two neighbouring heights with a vertex or a crossing, all edges are straight and do not cross, so that the result consists of trapezoids.
/// Their outer borders, joined, are the outline. Quadratic in the number of edges.</remarks>
internal static class PathCombination
{
    private const double Tolerance = 0.02;

    public static VectorPath Combine(VectorPath first, VectorPath second, GeometryCombineMode mode)
    {
        var edges = new List<CombinationEdge>();
        CombinationEdge.AddAll(edges, PathFlattener.Flatten(first, Matrix.Identity, Tolerance), isFirst: true);
        CombinationEdge.AddAll(edges, PathFlattener.Flatten(second, Matrix.Identity, Tolerance), isFirst: false);
        var inside = new CombinationRule(first.FillRule, second.FillRule, mode);
        var border = new BorderBuilder();
        var heights = Heights(edges);
        for (var i = 1; i < heights.Count; i++)
            border.AddBand(heights[i - 1], heights[i], Band(edges, inside, heights[i - 1], heights[i]));
        return border.Build();
    }

    private static List<double> Heights(List<CombinationEdge> edges)
    {
        var heights = new SortedSet<double>();
        foreach (var edge in edges)
        {
            heights.Add(edge.Top.Y);
            heights.Add(edge.Bottom.Y);
        }
        for (var i = 0; i < edges.Count; i++)
        {
            for (var j = i + 1; j < edges.Count; j++)
            {
                if (edges[i].TryCross(edges[j], out var height))
                    heights.Add(height);
            }
        }
        return [.. heights];
    }

    /// <summary>The inside between two heights as pairs of edges, left and right, from left to right.</summary>
    private static List<Trapezoid> Band(List<CombinationEdge> edges, CombinationRule inside, double top, double bottom)
    {
        var middle = (top + bottom) / 2;
        var crossing = edges.Where(edge => edge.Top.Y <= top && edge.Bottom.Y >= bottom).OrderBy(edge => edge.XAt(middle)).ToList();
        var trapezoids = new List<Trapezoid>();
        int firstWinding = 0, secondWinding = 0;
        CombinationEdge? left = null;
        foreach (var edge in crossing)
        {
            if (edge.IsFirst)
                firstWinding += edge.Winding;
            else
                secondWinding += edge.Winding;
            var isInside = inside.Holds(firstWinding, secondWinding);
            if (isInside && left is null)
            {
                left = edge;
            }
            else if (!isInside && left is { } start)
            {
                trapezoids.Add(new Trapezoid(start.XAt(top), edge.XAt(top), start.XAt(bottom), edge.XAt(bottom)));
                left = null;
            }
        }
        return trapezoids;
    }
}

/// <summary>Left and right ends of the upper and the lower side.</summary>
internal readonly record struct Trapezoid(double TopLeft, double TopRight, double BottomLeft, double BottomRight);
