using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>Searches the nearest start among contours that may be cut next: those without uncut contours inside or above them.</summary>
internal sealed class NearestStartSearch
{
    private readonly IReadOnlyList<Contour> _contours;
    private readonly ReadOnlyMemory<Segment> _segments;
    private readonly int[] _inside;
    private readonly int[] _waitsFor;

    /// <summary>For each contour, those that wait for it because they are below it; empty when there are none.</summary>
    private readonly List<int>?[] _below;
    private readonly bool[] _done;
    private readonly AvailableStarts _starts;
    private bool[]? _within;
    private int _left;

    public NearestStartSearch(IReadOnlyList<Contour> contours, ReadOnlyMemory<Segment> segments, ReadOnlySpan<int> inside, DepthOrder depth)
    {
        (_contours, _left) = (contours, contours.Count);
        _segments = segments;
        _inside = inside.ToArray();
        _done = new bool[contours.Count];
        _waitsFor = new int[contours.Count];
        foreach (var outer in inside)
        {
            if (outer >= 0) _waitsFor[outer]++;
        }

        _below = new List<int>?[depth.UpperLowerPairs.Count == 0 ? 0 : contours.Count];
        foreach (var (upper, lower) in depth.UpperLowerPairs)
        {
            _waitsFor[lower]++;
            (_below[upper] ??= []).Add(lower);
        }

        _starts = new AvailableStarts(contours, segments.Span, depth);
        for (var contour = 0; contour < contours.Count; contour++)
        {
            if (_waitsFor[contour] > 0 || !depth.IsNone) _starts.Set(contour, _waitsFor[contour] == 0);
        }
    }

    /// <summary>The nearest start, or null when no contour remains.</summary>
    public StrokeEntry? Next(Point2D tool)
    {
        var start = _starts.Nearest(tool);
        if (start is null && _left > 0 && _within is null)
        {
            ForEach(contour => !_done[contour], contour => _starts.Set(contour, true)); // they wait for each other, for example when an outline is above parts of its inside: all are still cut
            start = _starts.Nearest(tool);
        }

        if (start is not var (index, number, place)) return null;
        var contour = _contours[index];
        return contour.Closed ? StrokeEntry.At(number, index, contour, _segments.Span) : StrokeEntry.AtEnd(number, index, contour, place); // not reading the segment saves a memory access for each of a million contours
    }

    /// <summary>Removes a contour that was cut, and admits those that waited only for it.</summary>
    public void Done(int contour)
    {
        _left--;
        _done[contour] = true;
        _starts.Set(contour, false);
        if (_inside[contour] is >= 0 and var outer) Release(outer);
        if (_below.Length == 0) return;
        foreach (var lower in _below[contour] ?? []) Release(lower);
    }

    /// <summary>From now on only contours inside <paramref name="contour"/>, at any nesting depth, can be chosen.</summary>
    public void RestrictTo(int contour)
    {
        var within = _within = WithinFlags(contour);
        ForEach(other => !within[other], other => _starts.Set(other, false));
        _done[contour] = true; // the caller enters it; it is not chosen here
        _starts.Set(contour, false);
    }

    public void Unrestrict()
    {
        _within = null;
        ForEach(contour => !_done[contour] && _waitsFor[contour] == 0, contour => _starts.Set(contour, true));
    }

    public Point2D EndOf(StrokeEntry entry)
    {
        var contour = _contours[entry.Contour];
        return contour.Closed ? TravelOrder.EndOf(entry, contour, _segments.Span) : _starts.FarFrom(entry.Contour, entry.Kind == StrokeEntryKind.Turned ? 1 : 0);
    }

    private void Release(int contour)
    {
        if (--_waitsFor[contour] == 0 && !_done[contour] && _within?[contour] != false) _starts.Set(contour, true);
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
}
