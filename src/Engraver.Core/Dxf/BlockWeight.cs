namespace Engraver.Core.Dxf;

/// <summary>What one copy of a block amounts to. Sums stop at <see cref="Most"/>, so that no nesting can overflow them.</summary>
/// <param name="Curves">Curves after full expansion.</param>
/// <param name="Steps">Curves and inserts that an expansion visits; an insert that brings no curve is looked at, not followed.</param>
/// <param name="Depth">Levels of nesting, 1 for a block without inserts.</param>
/// <param name="Loses">True when something in it was refused.</param>
/// <param name="Annotations">Texts and points after full expansion, by type.</param>
internal sealed record BlockWeight(long Curves, long Steps, int Depth, bool Loses, IReadOnlyDictionary<string, long> Annotations)
{
    public const long Most = long.MaxValue / 4;

    public static long Sum(long left, long right) => Math.Min(left + right, Most);

    /// <summary>Copies times a sum; copies are at most 32767 x 32767.</summary>
    public static long Times(long copies, long amount) => amount > Most / copies ? Most : copies * amount;
}
