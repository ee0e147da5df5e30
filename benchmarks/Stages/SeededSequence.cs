namespace Engraver.Benchmarks.Stages;

/// <summary>Random-looking numbers that are the same on every platform and runtime for the same seed (SplitMix64, Steele, Lea and Flood 2014).</summary>
/// <remarks><see cref="Random"/> does not guarantee its sequence across versions of the runtime, and the samples must not change with it.</remarks>
internal sealed class SeededSequence(ulong seed)
{
    private ulong _state = seed;

    /// <summary>From 0 up to, but not including, <paramref name="limit"/>.</summary>
    public int Below(int limit) => (int)(NextBits() % (ulong)limit);

    /// <summary>From 0 up to, but not including, 1.</summary>
    public double Fraction() => (NextBits() >> 11) * (1.0 / (1UL << 53));

    public bool Coin() => Below(2) == 1;

    /// <summary>Puts the items into a random order, determined by the seed.</summary>
    public void Shuffle<T>(Span<T> items)
    {
        for (var i = items.Length - 1; i > 0; i--)
        {
            var j = Below(i + 1);
            (items[i], items[j]) = (items[j], items[i]);
        }
    }

    private ulong NextBits()
    {
        _state += 0x9E3779B97F4A7C15;
        var mixed = _state;
        mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
        return mixed ^ (mixed >> 31);
    }
}
