using Avalonia;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Geometry;

/// <summary>A straight edge that is not horizontal, from its upper to its lower end.</summary>
/// <param name="Winding">1 where the path runs downwards, else -1.</param>
/// <param name="IsFirst">Belongs to the first of the two paths.</param>
internal sealed record CombinationEdge(Vector Top, Vector Bottom, int Winding, bool IsFirst)
{
    public double XAt(double y)
    {
        if (y == Bottom.Y)
            return Bottom.X;
        return Top.X + (y - Top.Y) / (Bottom.Y - Top.Y) * (Bottom.X - Top.X);
    }

    public bool TryCross(CombinationEdge other, out double height)
    {
        height = 0;
        double from = Math.Max(Top.Y, other.Top.Y), to = Math.Min(Bottom.Y, other.Bottom.Y);
        if (to <= from)
            return false;
        double before = XAt(from) - other.XAt(from), after = XAt(to) - other.XAt(to);
        if (before * after >= 0)
            return false;
        height = from + before / (before - after) * (to - from);
        return height > from && height < to;
    }

    public static void AddAll(List<CombinationEdge> edges, List<Polyline> figures, bool isFirst)
    {
        foreach (var points in figures.Select(figure => figure.Points))
        {
            for (var i = 0; i < points.Count; i++)
            {
                Vector start = points[i], end = points[(i + 1) % points.Count];
                if (start.Y < end.Y)
                    edges.Add(new CombinationEdge(start, end, 1, isFirst));
                else if (start.Y > end.Y)
                    edges.Add(new CombinationEdge(end, start, -1, isFirst));
            }
        }
    }
}
