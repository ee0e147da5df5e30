using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>The possible starts of all contours, in their order (for a grid) and in short runs of neighbours (for a tree of boxes, because building a box for
/// each of a million joints would take far longer than the search).</summary>
/// <remarks>The two ends of an open contour are separate runs: they can be far apart, and depth may allow only one of them.</remarks>
internal sealed class StartRuns
{
    private const int LongestRun = 16;

    private readonly IReadOnlyList<Contour> _contours;
    private readonly Point2D[] _places;

    /// <summary>The first start and the first run of each contour; one element more than there are contours.</summary>
    private readonly int[] _starts;
    private readonly int[] _runs;

    public StartRuns(IReadOnlyList<Contour> contours, ReadOnlySpan<Segment> segments)
    {
        _contours = contours;
        (_starts, _runs) = (new int[contours.Count + 1], new int[contours.Count + 1]);
        for (var i = 0; i < contours.Count; i++)
        {
            var count = StrokeEntry.CountOf(contours[i], segments);
            _starts[i + 1] = _starts[i] + count;
            _runs[i + 1] = _runs[i] + (contours[i].Closed ? (count + LongestRun - 1) / LongestRun : count);
        }

        _places = new Point2D[_starts[^1]];
        for (var i = 0; i < contours.Count; i++)
        {
            for (var start = _starts[i]; start < _starts[i + 1]; start++) _places[start] = StrokeEntry.At(start - _starts[i], i, contours[i], segments).Place;
        }
    }

    /// <summary>The first run of a contour; for the number of contours, the number of runs.</summary>
    public int FirstOf(int contour) => _runs[contour];

    /// <summary>All starts, contour by contour.</summary>
    public ReadOnlySpan<Point2D> Places => _places;

    /// <summary>The numbers of a contour's starts among all.</summary>
    /// <returns>The first, and the one after the last.</returns>
    public (int First, int End) NumbersOf(int contour) => (_starts[contour], _starts[contour + 1]);

    public bool IsOpen(int contour) => !_contours[contour].Closed;

    /// <summary>The contour of each start.</summary>
    public int[] Contours()
    {
        var contours = GC.AllocateUninitializedArray<int>(_places.Length);
        for (var contour = 0; contour < _contours.Count; contour++) contours.AsSpan(_starts[contour].._starts[contour + 1]).Fill(contour);
        return contours;
    }

    /// <summary>True for the far end of an open contour.</summary>
    public bool IsFarEnd(int run, int contour) => IsOpen(contour) && run > _runs[contour];

    /// <summary>The box of each run.</summary>
    public Bounds2D[] Boxes()
    {
        var boxes = new Bounds2D[_runs[^1]];
        for (var contour = 0; contour < _contours.Count; contour++)
        {
            for (var run = _runs[contour]; run < _runs[contour + 1]; run++)
            {
                boxes[run] = Bounds2D.Empty;
                foreach (var place in PlacesOf(run, contour)) boxes[run] = boxes[run].Including(place);
            }
        }

        return boxes;
    }

    /// <summary>Distance of the nearest start of a run.</summary>
    public double Distance(int run, Point2D tool)
    {
        var nearest = double.PositiveInfinity;
        foreach (var place in PlacesOf(run, ContourOf(run))) nearest = Math.Min(nearest, place.DistanceTo(tool));
        return nearest;
    }

    /// <summary>The first start of a run at that distance.</summary>
    /// <returns>Its contour and its number among the starts of the contour.</returns>
    public (int Contour, int Number) StartAt(int run, Point2D tool, double distance)
    {
        var contour = ContourOf(run);
        var (places, at) = (PlacesOf(run, contour).ToArray(), 0);
        while (at + 1 < places.Length && places[at].DistanceTo(tool) > distance) at++;
        return (contour, FirstStartOf(run, contour) - _starts[contour] + at);
    }

    private int ContourOf(int run)
    {
        var at = Array.BinarySearch(_runs, run);
        return at >= 0 ? at : ~at - 1;
    }

    private int FirstStartOf(int run, int contour) => _starts[contour] + ((run - _runs[contour]) * (_contours[contour].Closed ? LongestRun : 1));

    private ReadOnlySpan<Point2D> PlacesOf(int run, int contour)
    {
        var first = FirstStartOf(run, contour);
        var end = run + 1 < _runs[contour + 1] ? FirstStartOf(run + 1, contour) : _starts[contour + 1];
        return _places.AsSpan(first, end - first);
    }
}
