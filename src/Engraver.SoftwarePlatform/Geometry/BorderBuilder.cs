using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Rasteriser.Paths;

namespace Engraver.SoftwarePlatform.Geometry;

/// <summary>Joins the borders of trapezoids, given in bands from the top, to closed figures. Sides shared by two bands are left out.</summary>
internal sealed class BorderBuilder
{
    private const double SamePlace = 1e-7;

    private readonly Dictionary<(long X, long Y), List<Vector>> _nextOf = [];
    private readonly Dictionary<(long X, long Y), Vector> _places = [];
    private List<Trapezoid> _above = [];
    private double _lastBottom = double.NaN;

    public void AddBand(double top, double bottom, List<Trapezoid> trapezoids)
    {
        AddLevel(_lastBottom, _above, top == _lastBottom ? trapezoids : []);
        if (top != _lastBottom)
            AddLevel(top, [], trapezoids);
        foreach (var part in trapezoids)
        {
            AddEdge(new Vector(part.TopRight, top), new Vector(part.BottomRight, bottom));
            AddEdge(new Vector(part.BottomLeft, bottom), new Vector(part.TopLeft, top));
        }
        _above = trapezoids;
        _lastBottom = bottom;
    }

    public VectorPath Build()
    {
        AddLevel(_lastBottom, _above, []);
        var path = new VectorPath(FillRule.NonZero);
        foreach (var start in _nextOf.Keys.ToArray())
        {
            while (_nextOf[start].Count > 0)
                AddFigure(path, start);
        }
        return path;
    }

    /// <summary>Horizontal borders: to the right on screen where there is only something below, to the left where there is only something above.</summary>
    private void AddLevel(double y, List<Trapezoid> above, List<Trapezoid> below)
    {
        var changes = new List<(double X, int Above, int Below)>();
        foreach (var part in above)
            changes.AddRange([(part.BottomLeft, 1, 0), (part.BottomRight, -1, 0)]);
        foreach (var part in below)
            changes.AddRange([(part.TopLeft, 0, 1), (part.TopRight, 0, -1)]);
        changes.Sort((a, b) => a.X.CompareTo(b.X));
        int isAbove = 0, isBelow = 0;
        for (var i = 0; i + 1 < changes.Count; i++)
        {
            isAbove += changes[i].Above;
            isBelow += changes[i].Below;
            Vector left = new(changes[i].X, y), right = new(changes[i + 1].X, y);
            if (isBelow > 0 && isAbove == 0)
                AddEdge(left, right);
            else if (isAbove > 0 && isBelow == 0)
                AddEdge(right, left);
        }
    }

    private void AddEdge(Vector from, Vector to)
    {
        (long X, long Y) start = Key(from), end = Key(to);
        if (start == end)
            return;
        _places.TryAdd(start, from);
        _places.TryAdd(end, to);
        if (!_nextOf.TryGetValue(start, out var next))
            _nextOf[start] = next = [];
        next.Add(to);
        _nextOf.TryAdd(end, []);
    }

    private void AddFigure(VectorPath path, (long X, long Y) start)
    {
        path.MoveTo(Place(_places[start]));
        var at = start;
        while (_nextOf[at] is { Count: > 0 } next)
        {
            var to = next[^1];
            next.RemoveAt(next.Count - 1);
            at = Key(to);
            if (at == start)
                break;
            path.LineTo(Place(to));
        }
        path.Close();
    }

    private static (long X, long Y) Key(Vector place) => ((long)Math.Round(place.X / SamePlace), (long)Math.Round(place.Y / SamePlace));

    private static Point Place(Vector place) => new(place.X, place.Y);
}
