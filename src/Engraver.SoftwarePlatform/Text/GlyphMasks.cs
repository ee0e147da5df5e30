using System.Collections.Concurrent;

namespace Engraver.SoftwarePlatform.Text;

/// <summary>Caches the masks of one typeface. Drops all when they become too many.</summary>
internal sealed class GlyphMasks(SoftwareTypeface typeface)
{
    private const int MaxBytes = 8 << 20;

    private readonly ConcurrentDictionary<(int Size, int Tone), SizedGlyphMasks> _sizes = new();
    private int _bytes;

    /// <param name="size">Result of <see cref="GlyphSize.ToParts"/>.</param>
    public SizedGlyphMasks Of(int size, TextTone tone)
    {
        if (Volatile.Read(ref _bytes) > MaxBytes)
        {
            _sizes.Clear();
            Interlocked.Exchange(ref _bytes, 0);
        }
        return _sizes.TryGetValue((size, tone.Level), out var known)
            ? known
            : _sizes.GetOrAdd((size, tone.Level), _ => new SizedGlyphMasks(typeface, size, tone, bytes => Interlocked.Add(ref _bytes, bytes)));
    }
}
