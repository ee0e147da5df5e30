using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>Connects the rows of a zigzag: back and forth through neighbouring rows, around a wall when the tool first reaches it, and with a lift only where
/// neither a straight step nor a short path along a wall leads to the next row.</summary>
internal sealed class ZigzagTour
{
    /// <summary>Longest path along a wall to the next row, in stepovers and tool radii together.</summary>
    private const double MaxLinkLength = 6.0;

    private readonly IReadOnlyList<PassChain> _walls;
    private readonly ZigzagRows _rows;
    private readonly LinkCheck _check;
    private readonly double _radius;
    private readonly double _longest;
    private readonly double _step;
    private readonly bool[] _done;
    private readonly bool[] _wallDone;
    private readonly ILookup<int, int> _byNumber;
    private readonly PassFinder _wallFinder;
    private readonly PassFinder _endFinder;
    private List<(PathPiece Piece, bool IsLink)> _moves = [];

    /// <summary>The area swept along the walls cut so far; null until it is requested again.</summary>
    private SweptReach? _cut;

    private ZigzagTour(IReadOnlyList<PassChain> walls, ZigzagRows rows, LinkCheck check, PocketOptions options)
    {
        (_walls, _rows, _check) = (walls, rows, check);
        _radius = options.ToolRadius * (1.0 + 1e-9);
        _longest = MaxLinkLength * (options.PassDistance + options.ToolRadius);
        _step = Math.Max(0.0, options.PassDistance - options.ToolRadius) * (1.0 + 1e-6);
        (_done, _wallDone) = (new bool[rows.Rows.Count], new bool[walls.Count]);
        _byNumber = Enumerable.Range(0, rows.Rows.Count).ToLookup(row => rows.Rows[row].Row);
        (_wallFinder, _endFinder) = (new PassFinder(walls), new PassFinder(rows.Ends));
    }

    public static List<List<(PathPiece Piece, bool IsLink)>> Strokes(IReadOnlyList<PassChain> walls, ZigzagRows rows, LinkCheck check, PocketOptions options)
    {
        var tour = new ZigzagTour(walls, rows, check, options);
        var strokes = new List<List<(PathPiece, bool)>>();
        for (var row = 0; row < rows.Rows.Count; row++)
        {
            if (tour._done[row]) continue;
            tour.Cut(row);
            strokes.Add(tour._moves);
            tour._moves = [];
        }

        for (var wall = 0; wall < walls.Count; wall++)
        {
            if (!tour._wallDone[wall]) strokes.Add([.. Round(walls[wall], walls[wall].Closed ? walls[wall].Middle : walls[wall].Start).Select(piece => (piece, false))]);
        }

        return strokes;
    }

    private void Cut(int first)
    {
        Point2D? tool = null;
        for (var (row, forwards) = (first, true); row >= 0; (row, forwards) = tool is { } at ? Next(row, at) : default)
        {
            _done[row] = true;
            var piece = forwards ? _rows.Rows[row].Piece : _rows.Rows[row].Piece.Reversed();
            CutWallAt(piece.Start, isEntry: tool is null);
            _moves.Add((piece, false));
            tool = piece.End;
            CutWallAt(piece.End, isEntry: false);
        }
    }

    /// <summary>Cuts around the wall at the end of a row, unless it was cut earlier. At the start the tool descends on the wall.</summary>
    private void CutWallAt(Point2D end, bool isEntry)
    {
        var (wall, place) = _wallFinder.Nearest(end);
        if (wall < 0 || _wallDone[wall] || !_walls[wall].Closed) return;
        var way = PathPiece.Line(end, place.Place);
        if (way.Length > _radius || !_check.StaysInside(way)) return;
        (_wallDone[wall], _cut) = (true, null);
        if (!isEntry) Link(way);
        _moves.AddRange(Round(_walls[wall], place).Select(piece => (piece, false)));
        Link(way.Reversed());
    }

    private static List<PathPiece> Round(PassChain wall, PassPlace from)
    {
        var pieces = new List<PathPiece>();
        if (wall.Closed) wall.AddForwards(from, from, pieces);
        else pieces.AddRange(wall.Pieces);
        return pieces;
    }

    private void Link(PathPiece way)
    {
        if (way.Length > 0.0) _moves.Add((way, true));
    }

    /// <summary>The neighbouring stretch with the shortest connection, and whether it is then cut forwards; -1 for none. The connection is added.</summary>
    private (int Row, bool Forwards) Next(int row, Point2D tool)
    {
        var number = _rows.Rows[row].Row;
        var candidates = _byNumber[number + 1].Concat(_byNumber[number - 1]).Where(other => !_done[other])
            .SelectMany(other => ((int, bool, Point2D)[])[(other, true, _rows.Rows[other].Piece.Start), (other, false, _rows.Rows[other].Piece.End)])
            .Where(other => other.Item3.DistanceTo(tool) <= _longest).OrderBy(other => other.Item3.DistanceTo(tool)).ToList();
        foreach (var (other, forwards, place) in candidates)
        {
            var way = PathPiece.Line(tool, place);
            if (!_check.StaysInside(way) || Uncut([way]) > _step) continue;
            Link(way);
            return (other, forwards);
        }

        foreach (var (other, forwards, place) in candidates)
        {
            if (PathAlong(tool, place) is not { } ways || Uncut(ways) > _step) continue;
            foreach (var way in ways) Link(way);
            return (other, forwards);
        }

        return (-1, false);
    }

    /// <summary>Length of a path through material that no pass along a wall has cut yet.</summary>
    private double Uncut(IEnumerable<PathPiece> ways)
    {
        _cut ??= new SweptReach([.. _walls.Where((_, wall) => _wallDone[wall]).SelectMany(wall => wall.Pieces)], _radius);
        return ways.Sum(way => LinkCheck.Uncut(way, _cut));
    }

    /// <summary>Along the loop at which both rows end, which is in the area cut by the pass along the wall.</summary>
    private List<PathPiece>? PathAlong(Point2D from, Point2D to)
    {
        var (first, start) = _endFinder.Nearest(from);
        var (second, end) = _endFinder.Nearest(to);
        if (first < 0 || first != second || _rows.Ends[first].ShorterLength(start, end) > _longest) return null;
        var way = new List<PathPiece>();
        if (start.Place != from) way.Add(PathPiece.Line(from, start.Place));
        _rows.Ends[first].AddShorter(start, end, way);
        if (end.Place != to) way.Add(PathPiece.Line(end.Place, to));
        return way;
    }
}

/// <summary>Finds the nearest place on any of several passes.</summary>
internal sealed class PassFinder
{
    private readonly IReadOnlyList<PassChain> _chains;
    private readonly (int Chain, int Piece)[] _items;
    private readonly BoxTree _tree;

    public PassFinder(IReadOnlyList<PassChain> chains)
    {
        _chains = chains;
        _items = [.. chains.SelectMany((chain, index) => Enumerable.Range(0, chain.Pieces.Length).Select(piece => (index, piece)))];
        _tree = BoxTree.Build([.. _items.Select(item => chains[item.Chain].Pieces[item.Piece].Box())]);
    }

    /// <summary>The number of the pass, -1 when there is none, and the place.</summary>
    public (int Chain, PassPlace Place) Nearest(Point2D place)
    {
        var nearest = _tree.Nearest(place, (item, from) => _chains[_items[item].Chain].Pieces[_items[item].Piece].DistanceTo(from), double.PositiveInfinity, out _);
        return nearest < 0 ? (-1, default) : (_items[nearest].Chain, _chains[_items[nearest].Chain].NearestOn(_items[nearest].Piece, place));
    }
}
