using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>Searches the nearest start among contours that may be cut next: those with nothing uncut inside them or over them.</summary>
internal sealed class NearestStartSearch
{
    private readonly IReadOnlyList<Contour> _contours;
    private readonly ReadOnlyMemory<Segment> _segments;
    private readonly int[] _inside;
    private readonly int[] _waitsFor;
    private readonly List<int>?[] _below;
    private readonly DepthOrder _depth;
    private readonly bool[] _done;
    private readonly StartRuns _starts;
    private readonly BoxTree _tree;
    private readonly BoxTree.Measure _measure;
    private bool[]? _within;
    private int _left;

    public NearestStartSearch(IReadOnlyList<Contour> contours, ReadOnlyMemory<Segment> segments, ReadOnlySpan<int> inside, DepthOrder depth)
    {
        (_contours, _depth, _left) = (contours, depth, contours.Count);
        _segments = segments;
        _inside = inside.ToArray();
        _done = new bool[contours.Count];
        _waitsFor = new int[contours.Count];
        foreach (var outer in inside)
        {
            if (outer >= 0) _waitsFor[outer]++;
        }

        _below = new List<int>?[contours.Count];
        foreach (var (upper, lower) in depth.Over)
        {
            _waitsFor[lower]++;
            (_below[upper] ??= []).Add(lower);
        }

        _starts = new StartRuns(contours, segments.Span);
        _tree = BoxTree.Build(_starts.Boxes());
        _measure = _starts.Distance;
        ForEach(_ => true, contour => Set(contour, _waitsFor[contour] == 0));
    }

    /// <summary>The nearest start, or null when nothing is left to choose.</summary>
    public StrokeEntry? Next(Point2D tool)
    {
        var run = Nearest(tool, out var distance);
        if (run < 0 && _left > 0 && _within is null)
        {
            ForEach(contour => !_done[contour], contour => Set(contour, true)); // they wait for each other, as where an outline lies over parts of what it encloses: nothing is left out for that
            run = Nearest(tool, out distance);
        }

        if (run < 0) return null;
        var (contour, number) = _starts.StartAt(run, tool, distance);
        return StrokeEntry.At(number, contour, _contours[contour], _segments.Span);
    }

    /// <summary>Removes a contour that was cut, and admits those that waited for it alone.</summary>
    public void Done(int contour)
    {
        _left--;
        _done[contour] = true;
        Set(contour, false);
        if (_inside[contour] is >= 0 and var outer) Release(outer);
        foreach (var lower in _below[contour] ?? []) Release(lower);
    }

    /// <summary>Until further notice only contours inside <paramref name="contour"/>, at any depth, can be chosen.</summary>
    public void RestrictTo(int contour)
    {
        var within = _within = WithinFlags(contour);
        ForEach(other => !within[other], other => Set(other, false));
        _done[contour] = true; // the caller enters it; it is not chosen here
        Set(contour, false);
    }

    public void Unrestrict()
    {
        _within = null;
        ForEach(contour => !_done[contour] && _waitsFor[contour] == 0, contour => Set(contour, true));
    }

    public Point2D EndOf(StrokeEntry entry) => TravelOrder.EndOf(entry, _contours[entry.Contour], _segments.Span);

    private int Nearest(Point2D tool, out double distance) => _tree.Nearest(tool, _measure, double.PositiveInfinity, out distance);

    private void Release(int contour)
    {
        if (--_waitsFor[contour] == 0 && !_done[contour] && _within?[contour] != false) Set(contour, true);
    }

    private bool[] WithinFlags(int contour)
    {
        var within = new bool[_contours.Count];
        var known = new bool[_contours.Count];
        var path = new List<int>();
        for (var i = 0; i < within.Length; i++)
        {
            path.Clear();
            var up = i;
            while (up >= 0 && up != contour && !known[up])
            {
                path.Add(up);
                up = _inside[up];
            }

            var isWithin = up >= 0 && (up == contour || within[up]);
            foreach (var passed in path) (within[passed], known[passed]) = (isWithin, true);
        }

        return within;
    }

    private void ForEach(Func<int, bool> chosen, Action<int> action)
    {
        for (var contour = 0; contour < _contours.Count; contour++)
        {
            if (chosen(contour)) action(contour);
        }
    }

    private void Set(int contour, bool shown)
    {
        for (var run = _starts.FirstOf(contour); run < _starts.FirstOf(contour + 1); run++)
        {
            if (shown && _depth.MayBegin(contour, _starts.IsFarEnd(run, contour))) _tree.Show(run);
            else _tree.Hide(run);
        }
    }
}
