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
    private readonly StrokeEntry[] _entries;
    private readonly int[] _firstEntry;
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

        _firstEntry = new int[contours.Count + 1];
        _entries = AllEntries();
        _tree = BoxTree.Build(PlacesOf(_entries));
        _measure = (entry, place) => _entries[entry].Place.DistanceTo(place);
        ForEach(_ => true, contour => Set(contour, _waitsFor[contour] == 0));
    }

    /// <summary>The nearest start, or null when nothing is left to choose.</summary>
    public StrokeEntry? Next(Point2D tool)
    {
        var entry = Nearest(tool);
        if (entry < 0 && _left > 0 && _within is null)
        {
            ForEach(contour => !_done[contour], contour => Set(contour, true)); // they wait for each other, as where an outline lies over parts of what it encloses: nothing is left out for that
            entry = Nearest(tool);
        }

        return entry < 0 ? null : _entries[entry];
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

    private int Nearest(Point2D tool) => _tree.Nearest(tool, _measure, double.PositiveInfinity, out _);

    private void Release(int contour)
    {
        if (--_waitsFor[contour] == 0 && !_done[contour] && _within?[contour] != false) Set(contour, true);
    }

    private StrokeEntry[] AllEntries()
    {
        var entries = new List<StrokeEntry>(_segments.Length + _contours.Count);
        for (var contour = 0; contour < _contours.Count; contour++)
        {
            StrokeEntry.AddAll(contour, _contours[contour], _segments.Span, entries);
            _firstEntry[contour + 1] = entries.Count;
        }

        return [.. entries];
    }

    private static Point2D[] PlacesOf(StrokeEntry[] entries)
    {
        var places = new Point2D[entries.Length];
        for (var entry = 0; entry < places.Length; entry++) places[entry] = entries[entry].Place;
        return places;
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
        for (var entry = _firstEntry[contour]; entry < _firstEntry[contour + 1]; entry++)
        {
            if (shown && _depth.MayBegin(_entries[entry])) _tree.Show(entry);
            else _tree.Hide(entry);
        }
    }
}
