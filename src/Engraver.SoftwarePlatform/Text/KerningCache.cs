namespace Engraver.SoftwarePlatform.Text;

/// <summary>Keeps the last pair for each of a few thousand places; another pair of the same place replaces it. A pair and its value are one number, so that
/// threads need no lock.</summary>
internal sealed class KerningCache
{
    private const int Places = 4096;
    private const int ValueBits = 16;
    private const long IsUsed = 1L << 62;

    private readonly long[] _entries = new long[Places];

    public bool TryGet(int first, int second, out int units)
    {
        var entry = Volatile.Read(ref _entries[Place(first, second)]);
        units = (short)entry;
        return entry >> ValueBits == Key(first, second) >> ValueBits;
    }

    public void Keep(int first, int second, int units) => Volatile.Write(ref _entries[Place(first, second)], Key(first, second) | (ushort)(short)units);

    private static int Place(int first, int second) => (first * 61 + second) & (Places - 1);

    private static long Key(int first, int second) => IsUsed | (long)(ushort)first << (2 * ValueBits) | (long)(ushort)second << ValueBits;
}
