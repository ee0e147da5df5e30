using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing.Chaining;

namespace Engraver.Core.Sequencing.Ordering;

/// <summary>Constraints of depth on the order of cutting, which prevent the tool from plunging into material that should have been cleared first: a contour
/// waits until the contours above it have been cut, and an open contour that descends is entered at its upper end.</summary>
/// <remarks>One contour is above another when a segment of each coincides in plan and its lowest end is higher. This is the case when the same path is cut at
/// several depths; contours that only cross in plan are not constrained.</remarks>
internal sealed class DepthOrder
{
    private readonly double _tolerance;
    private readonly double[] _rises;

    private DepthOrder(IReadOnlyCollection<(int Upper, int Lower)> over, double[] rises, double tolerance) => (UpperLowerPairs, _rises, _tolerance) = (over, rises, tolerance);

    /// <summary>All contours are at one height.</summary>
    public static DepthOrder None { get; } = new([], [], 0.0);

    /// <summary>Every contour can be started at either end.</summary>
    public bool IsNone => _rises.Length == 0;

    /// <summary>Each contour with the next one below it, by their indices.</summary>
    public IReadOnlyCollection<(int Upper, int Lower)> UpperLowerPairs { get; }

    /// <param name="contours">All contours of the segments.</param>
    /// <param name="segments">Rows of the contours by index.</param>
    /// <param name="heights">Heights of the ends.</param>
    /// <param name="tolerance">Millimetres within which segments coincide in plan.</param>
    /// <param name="heightTolerance">Millimetres by which heights must differ.</param>
    public static DepthOrder From(IReadOnlyList<Contour> contours, ReadOnlySpan<Segment> segments, EndHeights heights, double tolerance, double heightTolerance)
    {
        if (heights.AreFlat) return None;
        var (owners, floors, rises) = (new int[segments.Length], new double[contours.Count], new double[contours.Count]);
        for (var i = 0; i < contours.Count; i++)
        {
            var pieces = contours[i].Pieces.Span;
            floors[i] = double.PositiveInfinity;
            foreach (var piece in pieces)
            {
                owners[piece.Row] = i;
                floors[i] = Math.Min(floors[i], Math.Min(heights.HeightOf(piece.StartNumber), heights.HeightOf(piece.EndNumber)));
            }

            rises[i] = contours[i].Closed ? 0.0 : heights.HeightOf(pieces[^1].EndNumber) - heights.HeightOf(pieces[0].StartNumber);
        }

        return new DepthOrder(FindUpperLowerPairs(segments, owners, floors, tolerance, heightTolerance), rises, heightTolerance);
    }

    /// <summary>False for the lower end of an open contour.</summary>
    /// <param name="contour">Index of the contour.</param>
    /// <param name="isTurned">True when it is started at its far end.</param>
    public bool CanStart(int contour, bool isTurned)
    {
        if (IsNone) return true;
        var ahead = isTurned ? -_rises[contour] : _rises[contour];
        return ahead <= _tolerance;
    }

    /// <summary>Removes the nesting that would cut a contour before the contours above it: a contour is not inside a contour with which it coincides.</summary>
    /// <param name="inside">The contour directly around each one, -1 for none.</param>
    public void Untangle(Span<int> inside)
    {
        var uppers = UpperLowerPairs.ToLookup(pair => pair.Lower, pair => pair.Upper);
        var above = new HashSet<int>();
        var waiting = new Stack<int>();
        foreach (var lower in uppers.Select(group => group.Key))
        {
            above.Clear();
            waiting.Push(lower);
            while (waiting.TryPop(out var one))
            {
                foreach (var upper in uppers[one])
                {
                    if (above.Add(upper)) waiting.Push(upper);
                }
            }

            while (inside[lower] >= 0 && above.Contains(inside[lower])) inside[lower] = inside[inside[lower]];
        }
    }

    private static HashSet<(int Upper, int Lower)> FindUpperLowerPairs(ReadOnlySpan<Segment> segments, int[] owners, double[] floors, double tolerance, double heightTolerance)
    {
        var middles = new Point2D[segments.Length];
        for (var row = 0; row < middles.Length; row++) middles[row] = DuplicateRemoval.MiddleOf(segments[row]);
        var (grid, near, over) = (new EndGrid(middles, tolerance), new List<int>(), new HashSet<(int, int)>());
        foreach (var row in Enumerable.Range(0, middles.Length).OrderByDescending(row => floors[owners[row]]).ToList())
        {
            grid.Take(row);
            grid.Near(middles[row], near);
            var next = -1;
            foreach (var other in near)
            {
                if (floors[owners[row]] - floors[owners[other]] <= heightTolerance || (next >= 0 && floors[owners[other]] <= floors[owners[next]])) continue;
                if (DuplicateRemoval.AreSame(segments[row], segments[other], middles[row].DistanceTo(middles[other]), tolerance)) next = other;
            }

            if (next >= 0) over.Add((owners[row], owners[next]));
        }

        return over;
    }
}
