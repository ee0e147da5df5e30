using Engraver.Core.Geometry;
using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>A step between two adjacent passes.</summary>
/// <param name="From">Number of one pass.</param>
/// <param name="At">Place on it.</param>
/// <param name="To">Number of the other.</param>
/// <param name="Arrives">Place on the other pass.</param>
internal readonly record struct PassLink(int From, PassPlace At, int To, PassPlace Arrives)
{
    public PassLink Reversed() => new(To, Arrives, From, At);

    public PathPiece Path => PathPiece.Line(At.Place, Arrives.Place);
}

/// <summary>The adjacent passes of a region between which the tool can step.</summary>
/// <remarks>Every point of a pass is at the stepover from the previous level, every point of a sliver's pass at the radius from its level. Passes that are then
/// still unconnected, for example both walls of a narrow ring, are connected if they are near enough.</remarks>
internal sealed class PassGraph
{
    private readonly IReadOnlyList<PassChain> _chains;
    private readonly LinkCheck _check;
    private readonly List<PassLink>[] _links;
    private readonly int[] _group;
    private readonly PathPiece[] _pieces;
    private readonly int[] _owner;
    private readonly int[] _number;

    private PassGraph(IReadOnlyList<PassChain> chains, LinkCheck check)
    {
        (_chains, _check) = (chains, check);
        _links = [.. chains.Select(_ => new List<PassLink>())];
        _group = [.. Enumerable.Range(0, chains.Count)];
        _pieces = [.. chains.SelectMany(chain => chain.Pieces)];
        _owner = [.. chains.SelectMany((chain, index) => Enumerable.Repeat(index, chain.Pieces.Length))];
        _number = [.. chains.SelectMany(chain => Enumerable.Range(0, chain.Pieces.Length))];
    }

    public IReadOnlyList<PassLink> LinksOf(int chain) => _links[chain];

    public static PassGraph Of(IReadOnlyList<PassChain> chains, LinkCheck check)
    {
        var graph = new PassGraph(chains, check);
        graph.LinkLevels();
        graph.LinkGroups();
        return graph;
    }

    private void LinkLevels()
    {
        var levels = _chains.Max(chain => chain.Level) + 1;
        var members = Enumerable.Range(0, _chains.Count).ToLookup(chain => _chains[chain].Level);
        var items = Enumerable.Range(0, _pieces.Length).Where(item => _chains[_owner[item]] is { Closed: true, Kind: not PassKind.Sliver }).ToLookup(item => _chains[_owner[item]].Level);
        for (var level = 0; level < levels; level++)
        {
            int[] here = [.. items[level]];
            var tree = BoxTree.Build([.. here.Select(item => _pieces[item].Box())]);
            foreach (var sliver in members[level].Where(chain => _chains[chain].Kind == PassKind.Sliver)) Link(sliver, _chains[sliver].Closed ? _chains[sliver].Middle : _chains[sliver].Start, tree, here);
            foreach (var inner in members[level + 1].Where(chain => _chains[chain].Kind != PassKind.Sliver)) LinkLoop(inner, tree, here);
        }
    }

    /// <summary>Connects a loop with every loop of the previous level that one of its pieces is parallel to, in the middle of the longest of those.</summary>
    private void LinkLoop(int inner, BoxTree tree, int[] items)
    {
        var longest = new Dictionary<int, int>();
        var chain = _chains[inner];
        if (items.Length == 0) return;
        for (var i = 0; i < chain.Pieces.Length; i++)
        {
            var owner = _owner[items[NearestTo(chain.Pieces[i].At(0.5), tree, items, out _)]];
            if (!longest.TryGetValue(owner, out var best) || chain.Pieces[best].Length < chain.Pieces[i].Length) longest[owner] = i;
        }

        foreach (var piece in longest.Values) Link(inner, chain.At(piece, 0.5), tree, items);
    }

    private int NearestTo(Point2D place, BoxTree tree, int[] items, out double distance) => tree.Nearest(place, (item, from) => _pieces[items[item]].DistanceTo(from), double.PositiveInfinity, out distance);

    private void Link(int chain, PassPlace place, BoxTree tree, int[] items)
    {
        if (items.Length == 0) return;
        var item = items[NearestTo(place.Place, tree, items, out var distance)];
        Add(new PassLink(_owner[item], _chains[_owner[item]].NearestOn(_number[item], place.Place), chain, place), distance);
    }

    private void Add(PassLink link, double distance)
    {
        if (distance > _check.LongestStep || !_check.StaysInside(link.Path)) return;
        _links[link.From].Add(link);
        _links[link.To].Add(link.Reversed());
        _group[GroupOf(link.From)] = GroupOf(link.To);
    }

    private int GroupOf(int chain)
    {
        while (_group[chain] != chain) chain = _group[chain] = _group[_group[chain]];
        return chain;
    }

    /// <summary>Connects the passes that no level connects.</summary>
    private void LinkGroups()
    {
        int[] loops = [.. Enumerable.Range(0, _chains.Count).Where(chain => _chains[chain].Closed)];
        if (loops.Select(GroupOf).Distinct().Count() <= 1) return;
        var tree = BoxTree.Build([.. _pieces.Select(piece => piece.Box())]);
        foreach (var loop in loops.OrderBy(loop => _chains[loop].Length)) LinkToOther(loop, tree);
    }

    private void LinkToOther(int loop, BoxTree tree)
    {
        var best = default(PassLink?);
        foreach (var (piece, number) in _chains[loop].Pieces.Select((piece, number) => (piece, number)))
        {
            var within = Math.Min(_check.LongestStep, best?.Path.Length ?? double.PositiveInfinity);
            var item = tree.Nearest(piece.At(0.5), (other, from) => _chains[_owner[other]].Closed && GroupOf(_owner[other]) != GroupOf(loop) ? _pieces[other].DistanceTo(from) : double.PositiveInfinity, within, out var distance);
            if (item < 0 || double.IsInfinity(distance)) continue;
            var link = new PassLink(_owner[item], _chains[_owner[item]].NearestOn(_number[item], piece.At(0.5)), loop, _chains[loop].At(number, 0.5));
            if (_check.StaysInside(link.Path)) best = link;
        }

        if (best is { } found) Add(found, found.Path.Length);
    }
}
