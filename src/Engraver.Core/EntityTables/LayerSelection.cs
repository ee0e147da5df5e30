using Engraver.Core.Drawings;

namespace Engraver.Core.EntityTables;

/// <summary>Which layers are cut. Default: on, not frozen, plotted. Names are compared without regard to case, as in DXF.</summary>
/// <remarks>An entity that is hidden itself (code 60, or through its insert) is never cut, even if the selection includes its layer.</remarks>
/// <param name="Only">When not empty: only these layers, even when they are off, frozen or not plotted.</param>
/// <param name="Skip">Layers that are left out.</param>
public sealed record LayerSelection(IReadOnlyList<string> Only, IReadOnlyList<string> Skip)
{
    public static LayerSelection Default { get; } = new([], []);

    /// <summary>Names of the selection that the drawing does not have, each once, as the operator spelled them; empty when all are known.</summary>
    public IReadOnlyList<string> UnknownNames(IReadOnlyList<Layer> layers)
    {
        var known = layers.Select(layer => layer.Name).ToHashSet(StringComparer.OrdinalIgnoreCase);
        return [.. Only.Concat(Skip).Where(name => !known.Contains(name)).Distinct(StringComparer.OrdinalIgnoreCase)];
    }

    /// <summary>For each layer of the drawing whether it is cut.</summary>
    public bool[] Taken(IReadOnlyList<Layer> layers)
    {
        var only = Only.ToHashSet(StringComparer.OrdinalIgnoreCase);
        var skip = Skip.ToHashSet(StringComparer.OrdinalIgnoreCase);
        return [.. layers.Select(layer => (only.Count == 0 ? layer.CutByDefault : only.Contains(layer.Name)) && !skip.Contains(layer.Name))];
    }
}
