using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Sequencing.Nesting;

namespace Engraver.Core.Unions;

/// <summary>How often closed chains run around a point, all together.</summary>
internal sealed class WindingNumbers
{
    private readonly ContourRegion[] _regions;
    private readonly BoxTree _tree;
    private readonly List<int> _around = [];

    public WindingNumbers(IReadOnlyList<SourceChain> chains)
    {
        _regions = [.. chains.Select(chain => ContourDepth.RegionOf([chain]))];
        _tree = BoxTree.Build([.. _regions.Select(region => region.Bounds)]);
    }

    public int At(Point2D place)
    {
        _around.Clear();
        _tree.Containing(Bounds2D.FromCorners(place, place), _around);
        var sum = 0;
        foreach (var region in _around) sum += _regions[region].Winding(place);
        return sum;
    }
}
