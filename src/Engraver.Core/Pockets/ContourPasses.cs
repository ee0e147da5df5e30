using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Pockets;

/// <summary>Passes parallel to the walls of a region, and additional passes that clear the slivers left between passes farther apart than the radius (reference
/// section 5.2).</summary>
/// <remarks>
/// Let C be the area enclosed by a pass and C' the area enclosed by the next one, at the stepover S further in. A point of C is missed only when it is deeper
/// than R in C and farther than R from C'. Every such point is nearer than S - R to the loop at depth R in C, so that a pass along parts of that loop clears
/// it: along the parts that are themselves missed, and, if that leaves any material, along all parts that are farther than 2 R - S from C', which always
/// suffice.
/// </remarks>
internal sealed class ContourPasses
{
    private readonly RegionDepths _depths;
    private readonly PocketOptions _options;
    private readonly List<double> _distances = [];

    private ContourPasses(RegionDepths depths, PocketOptions options) => (_depths, _options) = (depths, options);

    /// <summary>The loops of each level, from the wall inwards.</summary>
    public List<List<PassChain>> Levels { get; } = [];

    /// <param name="depths">Depths of the region.</param>
    /// <param name="wall">Loops of the first level.</param>
    /// <param name="options">Tool and stepover.</param>
    public static ContourPasses Of(RegionDepths depths, List<PathPiece[]> wall, PocketOptions options)
    {
        var passes = new ContourPasses(depths, options);
        var first = options.ToolRadius + options.Allowance;
        var loops = wall;
        for (var level = 0; loops.Count > 0; loops = depths.At(first + (++level * options.PassDistance)))
        {
            passes.Levels.Add([.. loops.Select(loop => new PassChain(loop, loop[^1].End == loop[0].Start, level == 0 ? PassKind.Wall : PassKind.Contour, level))]);
            passes._distances.Add(first + (level * options.PassDistance));
        }

        return passes;
    }

    /// <summary>The passes that clear the slivers between the levels.</summary>
    /// <param name="generous">True for all passes that can be needed; otherwise those that almost always suffice.</param>
    public List<PassChain> Slivers(bool generous)
    {
        var slivers = new List<PassChain>();
        if (_options.PassDistance <= _options.ToolRadius) return slivers;
        for (var level = 0; level < Levels.Count; level++)
        {
            var loops = _depths.At(_distances[level] + _options.ToolRadius);
            PathPiece[] inner = level + 1 < Levels.Count ? [.. Levels[level + 1].SelectMany(chain => chain.Pieces)] : [];
            var reach = new SweptReach(inner, generous ? Math.Max((2.0 * _options.ToolRadius) - _options.PassDistance, 1e-3 * _options.ToolRadius) : _options.ToolRadius);
            foreach (var loop in loops) AddMissed(loop, inner.Length == 0 ? null : reach, level, slivers);
        }

        return slivers;
    }

    /// <summary>The parts of a loop that the next level does not reach, joined where they are consecutive.</summary>
    private static void AddMissed(PathPiece[] loop, SweptReach? reach, int level, List<PassChain> slivers)
    {
        var parts = new List<(int Piece, PiecePart Part)>();
        for (var i = 0; i < loop.Length; i++)
        {
            foreach (var part in reach?.PartsOutside(loop[i]) ?? [PiecePart.Whole]) parts.Add((i, part));
        }

        if (parts.Count == loop.Length && parts.TrueForAll(part => part.Part == PiecePart.Whole))
        {
            slivers.Add(new PassChain(loop, true, PassKind.Sliver, level));
            return;
        }

        var endsWhole = parts.Where(part => part.Part.To == 1.0).Select(part => part.Piece).ToHashSet();
        var first = Math.Max(0, parts.FindIndex(part => part.Part.From > 0.0 || !endsWhole.Contains((part.Piece + loop.Length - 1) % loop.Length)));
        var run = new List<PathPiece>();
        for (var i = 0; i < parts.Count; i++)
        {
            var (piece, part) = parts[(first + i) % parts.Count];
            var source = loop[piece];
            var next = source.Part(part.From, part.From == 0.0 ? source.Start : source.At(part.From), part.To, part.To == 1.0 ? source.End : source.At(part.To));
            if (run.Count > 0 && (part.From > 0.0 || run[^1].End != next.Start)) Flush(run, level, slivers);
            run.Add(next);
        }

        Flush(run, level, slivers);
    }

    private static void Flush(List<PathPiece> run, int level, List<PassChain> slivers)
    {
        if (run.Count > 0) slivers.Add(new PassChain([.. run], false, PassKind.Sliver, level));
        run.Clear();
    }
}
