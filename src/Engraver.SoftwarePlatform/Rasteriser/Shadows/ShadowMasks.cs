namespace Engraver.SoftwarePlatform.Rasteriser.Shadows;

/// <summary>Caches the masks of the soft shadows that were drawn last.</summary>
internal sealed class ShadowMasks
{
    private const int MaxMasks = 64;

    private readonly Dictionary<ShadowShape, CoverageMask> _masks = [];

    public CoverageMask Get(ShadowShape shape, DrawingScratch scratch)
    {
        if (_masks.TryGetValue(shape, out var known))
            return known;
        if (_masks.Count >= MaxMasks)
            Forget();
        return _masks[shape] = shape.Draw(scratch);
    }

    private void Forget()
    {
        foreach (var mask in _masks.Values)
            mask.Dispose();
        _masks.Clear();
    }
}
