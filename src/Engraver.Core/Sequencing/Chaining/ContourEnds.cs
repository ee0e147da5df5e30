using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;

namespace Engraver.Core.Sequencing.Chaining;

/// <summary>The ends of open contours, two for each, start before end, in contour order; without those of the strokes of letters. The distances of the
/// nearest other ends are computed only on request: a report shows perhaps a hundred of two million ends.</summary>
public sealed class ContourEnds : IndexedList<Discontinuity>
{
    /// <summary>Distance beyond which two ends are not considered an overlooked gap, millimetres.</summary>
    public const double WidestGap = 1.0;

    private readonly Point2D[] _places;
    private readonly int[] _rows;

    /// <summary>Heights of the ends; empty when all are at one height.</summary>
    private readonly double[] _levels;

    /// <summary>By contour: true when it is one short segment whose ends are clearly apart, so that the space between them is not a gap.</summary>
    private readonly bool[] _isApart;
    private readonly Lazy<Discontinuity[]> _measured;

    private ContourEnds(Point2D[] places, int[] rows, double[] levels, bool[] isApart)
    {
        (_places, _rows, _levels, _isApart) = (places, rows, levels, isApart);
        _measured = new Lazy<Discontinuity[]>(Measure);
    }

    public override int Count => _places.Length;

    /// <summary>Position of one of the ends, millimetres.</summary>
    public Point2D PlaceOf(int index) => _places[index];

    /// <summary>The row that ends there.</summary>
    public int RowOf(int index) => _rows[index];

    /// <param name="isLetter">Rows of letters; null if there are none.</param>
    internal static ContourEnds From(IReadOnlyList<Contour> contours, ReadOnlySpan<Segment> segments, EndHeights heights, Predicate<int>? isLetter)
    {
        var count = 2 * contours.Count(contour => HasGaps(contour, isLetter));
        var (places, rows, levels) = (new Point2D[count], new int[count], new double[heights.AreFlat ? 0 : count]);
        var isApart = new bool[count / 2];
        var end = 0;
        foreach (var contour in contours)
        {
            if (!HasGaps(contour, isLetter)) continue;
            var pieces = contour.Pieces.Span;
            (places[end], rows[end]) = (pieces[0].StartIn(segments), pieces[0].Row);
            (places[end + 1], rows[end + 1]) = (pieces[^1].EndIn(segments), pieces[^1].Row);
            if (levels.Length > 0) (levels[end], levels[end + 1]) = (heights.HeightOf(pieces[0].StartNumber), heights.HeightOf(pieces[^1].EndNumber));
            isApart[end / 2] = pieces.Length == 1 && places[end].DistanceTo(places[end + 1]) is < WidestGap and var apart && 2.0 * apart >= segments[rows[end]].Length;
            end += 2;
        }

        return new ContourEnds(places, rows, levels, isApart);
    }

    private static bool HasGaps(Contour contour, Predicate<int>? isLetter)
    {
        var pieces = contour.Pieces.Span;
        return !contour.Closed && !(isLetter is not null && isLetter(pieces[0].Row) && isLetter(pieces[^1].Row));
    }

    /// <summary>Separates the ends that have another end nearby from the others.</summary>
    /// <param name="beyond">Lower limit in millimetres; a tolerance could not join an end within this distance.</param>
    /// <param name="within">Upper limit in millimetres; an end at exactly this distance does not count.</param>
    /// <param name="listed">Number of those ends that are reported with their distance.</param>
    internal NearbyEnds FindNearby(double beyond, double within, int listed)
    {
        var grid = _levels.Length == 0 ? PlaceGrid.TryBuild(_places) : null;
        var isNear = new bool[Count];
        if (grid is null)
        {
            for (var i = 0; i < Count; i++) isNear[i] = this[i].Gap is { } gap && gap > beyond && gap < within;
        }
        else
        {
            foreach (var i in grid.ByCell().ToArray()) isNear[i] = NearestIn(grid, i, within, out var gap) >= 0 && gap > beyond && gap < within;
        }

        var (count, measured, firstFar) = (0, new List<Discontinuity>(), -1);
        for (var i = 0; i < isNear.Length; i++)
        {
            if (!isNear[i]) firstFar = firstFar < 0 ? i : firstFar;
            else if (count++ < listed) measured.Add(grid is null ? this[i] : MeasureIn(grid, i));
        }

        return new NearbyEnds(count, measured, firstFar);
    }

    protected override Discontinuity ItemAt(int index) => _measured.Value[index];

    private Discontinuity[] Measure()
    {
        var ends = new Discontinuity[Count];
        if (_levels.Length == 0 && PlaceGrid.TryBuild(_places) is { } grid)
        {
            foreach (var i in grid.ByCell().ToArray()) ends[i] = MeasureIn(grid, i);
            return ends;
        }

        var tree = BoxTree.Build(_places);
        foreach (var i in tree.AlongCurve)
        {
            tree.Hide(i);
            if (_isApart[i / 2]) tree.Hide(OtherEnd(i));
            var other = tree.Nearest(_places[i], (end, place) => DistanceOf(end, i, place), double.PositiveInfinity, out var gap);
            tree.Show(i);
            if (_isApart[i / 2]) tree.Show(OtherEnd(i));
            ends[i] = End(i, other, gap);
        }

        return ends;
    }

    private Discontinuity MeasureIn(PlaceGrid grid, int index)
    {
        var other = NearestIn(grid, index, double.PositiveInfinity, out var gap);
        return End(index, other, gap);
    }

    /// <summary>The nearest end, without the other end of the same contour if this is one short segment.</summary>
    private int NearestIn(PlaceGrid grid, int index, double within, out double gap)
    {
        if (_isApart[index / 2]) grid.Hide(OtherEnd(index));
        var other = grid.Nearest(_places[index], index, within, out gap);
        if (_isApart[index / 2]) grid.Show(OtherEnd(index));
        return other;
    }

    private static int OtherEnd(int index) => index ^ 1;

    private double DistanceOf(int end, int from, Point2D place)
    {
        var inPlan = _places[end].DistanceTo(place);
        return _levels.Length == 0 ? inPlan : double.Hypot(inPlan, _levels[end] - _levels[from]);
    }

    private Discontinuity End(int index, int other, double gap) => new(_places[index], _rows[index], other < 0 ? null : gap, other < 0 ? -1 : _rows[other]);

    /// <summary>The ends that have another end nearby.</summary>
    /// <param name="Count">Number of these ends.</param>
    /// <param name="Measured">The first of them.</param>
    /// <param name="FirstFar">The first end without another end nearby; -1 when all have one.</param>
    internal readonly record struct NearbyEnds(int Count, IReadOnlyList<Discontinuity> Measured, int FirstFar);
}
