namespace Engraver.Core.Dxf;

/// <summary>What one copy of a block amounts to. Sums stop at <see cref="Most"/>, so that no nesting can overflow them.</summary>
/// <param name="Curves">Curves after full expansion.</param>
/// <param name="Steps">Curves and inserts that an expansion visits; an insert that brings no curve is looked at, not followed.</param>
/// <param name="Loses">True when something in it was refused.</param>
/// <param name="Annotations">Texts and points after full expansion, by type.</param>
/// <param name="TextSteps">Texts and the inserts on the way to them; 0 when there is no text in it.</param>
/// <param name="ConstructionSteps">Counts of construction (a type on a layer) and the inserts on the way to them; 0 when there is none in it.</param>
internal sealed record BlockWeight(long Curves, long Steps, bool Loses, IReadOnlyDictionary<string, long> Annotations, long TextSteps, long ConstructionSteps)
{
    public const long Most = long.MaxValue / 4;

    public static long Sum(long left, long right) => Math.Min(left + right, Most);

    /// <summary>Copies times a sum; copies are at most 32767 x 32767.</summary>
    public static long Times(long copies, long amount) => amount > Most / copies ? Most : copies * amount;
}
