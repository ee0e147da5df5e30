using Engraver.Core.Geometry;

namespace Engraver.Core.Offsets.Pieces;

/// <summary>Boxes over consecutive pieces. Neighbours on a chain are neighbours in the plane, so that the order of the chain is the order of the tree and
/// nothing is sorted.</summary>
/// <remarks>In contrast to <see cref="BoxTree"/>, which sorts and hides, this tree finds every pair of overlapping pieces, and distances without a call through
/// a delegate.</remarks>
internal sealed class PieceTree
{
    private const int Fanout = 4;
    private readonly PathPiece[] _pieces;
    private readonly SlantedBox[][] _boxes;

    public PieceTree(PathPiece[] pieces)
    {
        _pieces = pieces;
        var leaves = new SlantedBox[pieces.Length];
        for (var i = 0; i < leaves.Length; i++) leaves[i] = SlantedBox.Of(pieces[i]);
        var levels = new List<SlantedBox[]> { leaves };
        while (levels[^1].Length > 1) levels.Add(Above(levels[^1]));
        _boxes = [.. levels];
    }

    public IReadOnlyList<PathPiece> Pieces => _pieces;

    /// <summary>Every pair of pieces whose boxes are not separated by <paramref name="slack"/>, except lines that are clearly apart; the lower number
    /// first.</summary>
    public List<(int First, int Second)> Pairs(double slack)
    {
        var pairs = new List<(int, int)>(_pieces.Length * 2);
        if (_pieces.Length > 1) WithItself(_boxes.Length - 1, 0, slack, pairs);
        return pairs;
    }

    /// <summary>Distance of the nearest piece, or <paramref name="within"/> when none is nearer.</summary>
    public double Nearest(Point2D place, double within)
    {
        NearestPiece(place, ref within);
        return within;
    }

    /// <summary>Number of the nearest piece, -1 when none is nearer than <paramref name="within"/>, which becomes its distance.</summary>
    public int NearestPiece(Point2D place, ref double within)
    {
        var piece = -1;
        if (_pieces.Length > 0) Descend(_boxes.Length - 1, 0, place, ref within, ref piece);
        return piece;
    }

    /// <summary>True when any piece is nearer than a distance.</summary>
    public bool IsAnyWithin(Point2D place, double distance) => _pieces.Length > 0 && Reaches(_boxes.Length - 1, 0, place, distance);

    /// <summary>Adds the number of every piece whose box is not farther than a distance.</summary>
    public void AddNear(Point2D place, double distance, List<int> found)
    {
        if (_pieces.Length > 0) Collect(_boxes.Length - 1, 0, place, distance, found);
    }

    private static SlantedBox[] Above(SlantedBox[] below)
    {
        var above = new SlantedBox[(below.Length + Fanout - 1) / Fanout];
        for (var i = 0; i < above.Length; i++) above[i] = SlantedBox.Around(below.AsSpan(i * Fanout, Math.Min(Fanout, below.Length - (i * Fanout))));
        return above;
    }

    /// <summary>True when the other piece, a line, is clearly on one side of a line: thousands of boxes of long slanted lines overlap.</summary>
    private static bool AreApart(in PathPiece line, in PathPiece other, double slack)
    {
        if (line.IsArc || other.IsArc) return false;
        var along = line.End - line.Start;
        var (start, end) = (along.Cross(other.Start - line.Start), along.Cross(other.End - line.Start));
        var least = 4.0 * slack * line.Length;
        return (start > least && end > least) || (start < -least && end < -least);
    }

    private int EndOf(int level, int index) => Math.Min((index + 1) * Fanout, _boxes[level - 1].Length);

    private void WithItself(int level, int index, double slack, List<(int, int)> pairs)
    {
        if (level == 0) return;
        var end = EndOf(level, index);
        for (var child = index * Fanout; child < end; child++)
        {
            WithItself(level - 1, child, slack, pairs);
            for (var other = child + 1; other < end; other++) WithOther(level - 1, child, other, slack, pairs);
        }
    }

    private void WithOther(int level, int first, int second, double slack, List<(int, int)> pairs)
    {
        var boxes = _boxes[level];
        if (!boxes[first].Overlaps(boxes[second], slack)) return;
        if (level == 0)
        {
            if (!AreApart(_pieces[first], _pieces[second], slack) && !AreApart(_pieces[second], _pieces[first], slack)) pairs.Add((first, second));
            return;
        }

        var (endOfFirst, endOfSecond) = (EndOf(level, first), EndOf(level, second));
        for (var child = first * Fanout; child < endOfFirst; child++)
        {
            if (!_boxes[level - 1][child].Overlaps(boxes[second], slack)) continue;
            for (var other = second * Fanout; other < endOfSecond; other++) WithOther(level - 1, child, other, slack, pairs);
        }
    }

    private void Descend(int level, int index, Point2D place, ref double within, ref int piece)
    {
        if (_boxes[level][index].SquaredDistance(place) >= within * within) return;
        if (level == 0)
        {
            if (_pieces[index].DistanceTo(place) is var found && found < within) (within, piece) = (found, index);
            return;
        }

        var first = index * Fanout;
        var count = EndOf(level, index) - first;
        Span<double> squares = stackalloc double[Fanout];
        for (var i = 0; i < count; i++) squares[i] = _boxes[level - 1][first + i].SquaredDistance(place);
        for (var visit = 0; visit < count; visit++)
        {
            var nearest = 0;
            for (var i = 1; i < count; i++) nearest = squares[i] < squares[nearest] ? i : nearest;
            if (squares[nearest] >= within * within) return;
            squares[nearest] = double.PositiveInfinity;
            Descend(level - 1, first + nearest, place, ref within, ref piece);
        }
    }

    private bool Reaches(int level, int index, Point2D place, double distance)
    {
        if (_boxes[level][index].SquaredDistance(place) >= distance * distance) return false;
        if (level == 0) return _pieces[index].DistanceTo(place) < distance;
        var end = EndOf(level, index);
        for (var child = index * Fanout; child < end; child++)
        {
            if (Reaches(level - 1, child, place, distance)) return true;
        }

        return false;
    }

    private void Collect(int level, int index, Point2D place, double distance, List<int> found)
    {
        if (_boxes[level][index].SquaredDistance(place) > distance * distance) return;
        if (level == 0)
        {
            found.Add(index);
            return;
        }

        var end = EndOf(level, index);
        for (var child = index * Fanout; child < end; child++) Collect(level - 1, child, place, distance, found);
    }
}
