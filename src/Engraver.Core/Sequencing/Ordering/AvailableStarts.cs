using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>The possible starts of the contours that may be cut next. The nearest one is found in a grid of places when many contours are spread evenly,
/// otherwise in a tree of boxes.</summary>
internal sealed class AvailableStarts
{
    /// <summary>A search of fewer starts is as fast in a tree.</summary>
    private const int MinForGrid = 256;

    /// <summary>Starts for each contour: with more, creating a grid takes longer than it saves.</summary>
    private const int MaxForGrid = 8;

    private readonly StartRuns _starts;
    private readonly DepthOrder _depth;
    private readonly PlaceGrid? _grid;

    /// <summary>With a grid, the contour of each start.</summary>
    private readonly int[] _contourOf = [];

    /// <summary>Tree of the runs; null with a grid.</summary>
    private readonly BoxTree? _tree;
    private readonly BoxTree.Measure _measure;

    public AvailableStarts(IReadOnlyList<Contour> contours, ReadOnlySpan<Segment> segments, DepthOrder depth)
    {
        _depth = depth;
        _starts = new StartRuns(contours, segments);
        _measure = _starts.Distance;
        if (_starts.Places.Length >= MinForGrid && _starts.Places.Length / MaxForGrid <= contours.Count) _grid = PlaceGrid.TryBuild(_starts.Places);
        if (_grid is null) _tree = BoxTree.Build(_starts.Boxes());
        else _contourOf = _starts.Contours();
    }

    /// <summary>All starts are shown at first. Shows those starts of a contour that depth allows, or hides all of them.</summary>
    public void Set(int contour, bool shown)
    {
        if (_grid is { } grid)
        {
            var (first, end) = _starts.NumbersOf(contour);
            for (var place = first; place < end; place++) Set(grid, place, shown && _depth.CanStart(contour, isTurned: _starts.IsOpen(contour) && place > first));
            return;
        }

        for (var run = _starts.FirstOf(contour); run < _starts.FirstOf(contour + 1); run++)
        {
            if (shown && _depth.CanStart(contour, _starts.IsFarEnd(run, contour))) _tree!.Show(run);
            else _tree!.Hide(run);
        }
    }

    /// <summary>The nearest shown start, in case of a tie the lower contour and its drawn start; null when none is shown.</summary>
    /// <returns>Its contour, its number among the starts of the contour, and its position.</returns>
    public (int Contour, int Number, Point2D Place)? Nearest(Point2D tool)
    {
        if (_grid is { } grid) return grid.Nearest(tool, -1, double.PositiveInfinity, out _) is >= 0 and var start ? (_contourOf[start], start - _starts.NumbersOf(_contourOf[start]).First, _starts.Places[start]) : null;
        var run = _tree!.Nearest(tool, _measure, double.PositiveInfinity, out var distance);
        if (run < 0) return null;
        var (contour, number) = _starts.StartAt(run, tool, distance);
        return (contour, number, _starts.Places[_starts.NumbersOf(contour).First + number]);
    }

    /// <summary>The other end of an open contour.</summary>
    /// <param name="number">0 for the end, 1 for the start.</param>
    public Point2D FarFrom(int contour, int number) => _starts.Places[_starts.NumbersOf(contour).First + 1 - number];

    private static void Set(PlaceGrid grid, int place, bool shown)
    {
        if (shown) grid.Show(place);
        else grid.Hide(place);
    }
}
