namespace Engraver.Core.Reshaping;

/// <summary>The result of trimming or breaking an object: the removed and the remaining parts together are the whole object.</summary>
/// <param name="Removed">Removed pieces in the direction of the object; empty when it is only split.</param>
/// <param name="Remaining">Remaining pieces; each becomes a separate object; empty when nothing remains.</param>
public sealed record PathCut(IReadOnlyList<PathRange> Removed, IReadOnlyList<IReadOnlyList<PathRange>> Remaining)
{
    /// <summary>TRIM: Removes the part around a place, up to the next crossing on either side.</summary>
    /// <param name="crossings">Crossings from <see cref="EntityPath.Crossings"/>.</param>
    /// <returns>Null when nothing crosses the object, or a closed one fewer than two times.</returns>
    public static PathCut? Trim(EntityPath path, IReadOnlyList<PathPlace> crossings, PathPlace picked)
    {
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(crossings);
        var least = path.Closed ? 2 : 1;
        if (crossings.Count < least) return null;
        var next = 0;
        while (next < crossings.Count && crossings[next].Position <= picked.Position) next++;
        if (path.Closed) return RemoveBetween(path, crossings[(next + crossings.Count - 1) % crossings.Count], crossings[next % crossings.Count]);
        return RemoveBetween(path, next > 0 ? crossings[next - 1] : path.Start, next < crossings.Count ? crossings[next] : path.End);
    }

    /// <summary>BREAK: Removes the part between two places of an open object; for a closed object, the part from the first to the second in its direction. Two
    /// equal places split the object there.</summary>
    public static PathCut Break(EntityPath path, PathPlace first, PathPlace second)
    {
        ArgumentNullException.ThrowIfNull(path);
        return !path.Closed && second.Position < first.Position ? RemoveBetween(path, second, first) : RemoveBetween(path, first, second);
    }

    private static PathCut RemoveBetween(EntityPath path, PathPlace from, PathPlace to)
    {
        var parted = from == to;
        var removed = parted ? [] : path.Between(from, to);
        if (path.Closed) return new PathCut(removed, [path.Between(to, from)]);
        IReadOnlyList<PathRange>[] kept = [path.Between(path.Start, from), path.Between(to, path.End)];
        return new PathCut(removed, [.. kept.Where(pieces => pieces.Count > 0)]);
    }
}
