using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>Assigns small numbers to blocks within blocks.</summary>
internal sealed class BlockPathTable
{
    private readonly List<BlockPath> _paths = [BlockPath.None];
    private readonly Dictionary<BlockPath, int> _numbers = [];

    public IReadOnlyList<BlockPath> Paths => _paths;

    /// <summary>The number of a block inside of a path; 0 is model space.</summary>
    public int Inside(int around, int block)
    {
        var path = new BlockPath(block, around);
        if (_numbers.TryGetValue(path, out var number)) return number;
        _paths.Add(path);
        return _numbers[path] = _paths.Count - 1;
    }
}
