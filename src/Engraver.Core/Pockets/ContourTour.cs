using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>Connects the contour-parallel passes of a region: from the wall inwards, along each branch and back to its start, so that the tool is lifted only
/// where there is no step to the next pass.</summary>
/// <remarks>Along the main branch a pass is cut completely before the next one; adjacent passes (slivers in corners, other lobes) are cut when the tool reaches
/// them. No pass is cut twice.</remarks>
internal sealed class ContourTour
{
    private readonly IReadOnlyList<PassChain> _chains;
    private readonly PassGraph _graph;
    private readonly LinkCheck _check;
    private readonly bool _reverses;
    private readonly bool[] _taken;
    private readonly List<(PathPiece Piece, bool IsLink)> _moves = [];
    private readonly Stack<ChainVisit> _open = new();

    private ContourTour(IReadOnlyList<PassChain> chains, LinkCheck check, bool reverses)
    {
        (_chains, _check, _reverses) = (chains, check, reverses);
        _graph = PassGraph.Of(chains, check);
        _taken = new bool[chains.Count];
    }

    /// <summary>Strokes with their moves; every pass is in one of them.</summary>
    /// <param name="chains">All passes of the region.</param>
    /// <param name="check">Check of its links.</param>
    /// <param name="fromCentre">Reverse order: the last pass is the one along the wall.</param>
    public static List<List<(PathPiece Piece, bool IsLink)>> Strokes(IReadOnlyList<PassChain> chains, LinkCheck check, bool fromCentre)
    {
        var tour = new ContourTour(fromCentre ? [.. chains.Select(chain => chain.Reversed())] : chains, check, fromCentre);
        var strokes = new List<List<(PathPiece, bool)>>();
        foreach (var root in Enumerable.Range(0, chains.Count).OrderBy(chain => chains[chain].Kind == PassKind.Sliver).ThenBy(chain => chains[chain].Level).ThenByDescending(chain => chains[chain].Length))
        {
            if (tour._taken[root]) continue;
            tour.Cut(root);
            strokes.Add(fromCentre ? Reversed(tour._moves) : [.. tour._moves]);
            tour._moves.Clear();
        }

        return strokes;
    }

    private void Cut(int root)
    {
        _taken[root] = true;
        var start = _chains[root].Closed ? _graph.LinksOf(root).Where(link => !_taken[link.To]).OrderByDescending(link => _chains[link.To].Length).Select(link => (PassPlace?)link.At).FirstOrDefault() ?? _chains[root].Middle : _chains[root].Start;
        Open(root, start, null);
        while (_open.TryPeek(out var visit))
        {
            if (visit.Branches.TryDequeue(out var branch)) Branch(visit, branch);
            else Finish(visit);
        }
    }

    private void Open(int chain, PassPlace arrived, PassLink? back)
    {
        var visit = new ChainVisit(chain, arrived, back);
        List<PassLink> branches = [.. _graph.LinksOf(chain).Where(link => !_taken[link.To]).DistinctBy(link => link.To)];
        if (back is null && branches.Where(link => _chains[link.To].Kind != PassKind.Sliver).OrderByDescending(link => _chains[link.To].Length).Select(link => (PassLink?)link).FirstOrDefault() is { } main)
        {
            branches.Remove(main);
            visit.Main = Straight(main, arrived);
            _taken[main.To] = true;
        }

        foreach (var branch in branches.OrderBy(link => Ahead(_chains[chain], arrived, link.At)))
        {
            _taken[branch.To] = true;
            visit.Branches.Enqueue(branch);
        }

        _open.Push(visit);
    }

    private static double Ahead(PassChain chain, PassPlace from, PassPlace to) => to.Along - from.Along is var ahead && ahead < -PassChain.Joint ? ahead + chain.Length : ahead;

    /// <summary>The step to the next pass from the start of this pass when the next one is directly adjacent; otherwise from the point where they are
    /// adjacent.</summary>
    private PassLink Straight(PassLink main, PassPlace arrived)
    {
        var link = main with { At = arrived, Arrives = _chains[main.To].Nearest(arrived.Place) };
        return link.Path.Length <= _check.LongestStep && _check.StaysInside(link.Path) ? link : main;
    }

    private void Branch(ChainVisit visit, PassLink branch)
    {
        Forwards(visit, branch.At);
        branch = branch with { At = visit.At };
        Step(branch);
        var chain = _chains[branch.To];
        if (chain.Closed) Open(branch.To, branch.Arrives, branch.Reversed());
        else ThereAndBack(chain, branch);
    }

    /// <summary>Along a sliver's pass, and straight back if the return is through the cut area; otherwise along the same path.</summary>
    private void ThereAndBack(PassChain chain, PassLink branch)
    {
        _moves.AddRange(chain.Pieces.Select(piece => (piece, false)));
        var straight = PathPiece.Line(chain.Pieces[^1].End, branch.At.Place);
        if (!_reverses && _check.StaysInside(straight) && _check.Uncut(straight, [.. chain.Pieces, branch.Path]) == 0.0)
        {
            Add(straight, isLink: true);
            return;
        }

        _moves.AddRange(chain.Reversed().Pieces.Select(piece => (piece, !_reverses)));
        Step(branch.Reversed());
    }

    private void Finish(ChainVisit visit)
    {
        _open.Pop();
        var chain = _chains[visit.Chain];
        if (!chain.Closed)
        {
            _moves.AddRange(chain.Pieces.Select(piece => (piece, false)));
            return;
        }

        Add(chain, visit.At, visit.Arrived, isLink: false);
        if (visit.Back is { } back) Step(back);
        if (visit.Main is not { } main) return;
        var walk = new List<PathPiece>();
        if (Math.Abs(main.At.Along - visit.Arrived.Along) > PassChain.Joint) chain.AddShorter(visit.Arrived, main.At, walk);
        foreach (var piece in walk) Add(piece, isLink: !_reverses);
        Step(main);
        Open(main.To, main.Arrives, null);
    }

    private void Forwards(ChainVisit visit, PassPlace to)
    {
        if (Math.Abs(to.Along - visit.At.Along) <= PassChain.Joint) return;
        Add(_chains[visit.Chain], visit.At, to, isLink: false);
        visit.At = to;
    }

    private void Add(PassChain chain, PassPlace from, PassPlace to, bool isLink)
    {
        var pieces = new List<PathPiece>();
        chain.AddForwards(from, to, pieces);
        foreach (var piece in pieces) Add(piece, isLink);
    }

    private void Step(PassLink link) => Add(link.Path, isLink: true);

    private void Add(PathPiece piece, bool isLink)
    {
        if (piece.Length <= 0.0) return;
        _moves.Add((piece, isLink));
    }

    private static List<(PathPiece, bool)> Reversed(List<(PathPiece Piece, bool IsLink)> moves)
    {
        var reversed = new List<(PathPiece, bool)>(moves.Count);
        for (var i = moves.Count - 1; i >= 0; i--) reversed.Add((moves[i].Piece.Reversed(), moves[i].IsLink));
        return reversed;
    }

    /// <summary>A pass that is being cut.</summary>
    private sealed class ChainVisit(int chain, PassPlace arrived, PassLink? back)
    {
        public int Chain { get; } = chain;

        public PassPlace Arrived { get; } = arrived;

        /// <summary>The length cut so far.</summary>
        public PassPlace At { get; set; } = arrived;

        public PassLink? Back { get; } = back;

        /// <summary>Adjacent passes, in the order in which the tool reaches them.</summary>
        public Queue<PassLink> Branches { get; } = new();

        /// <summary>The position at which it continues afterwards.</summary>
        public PassLink? Main { get; set; }
    }
}
