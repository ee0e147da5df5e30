namespace Engraver.Core.Dxf.Blocks;

/// <summary>Content and cost of one copy of a block. Sums are limited to <see cref="Max"/>, so that nesting cannot overflow them.</summary>
/// <param name="Curves">Curves after full expansion.</param>
/// <param name="Steps">Curves and inserts that an expansion visits; an insert without curves counts, but its content does not.</param>
/// <param name="HasUnfollowedInserts">True when something in it was refused.</param>
/// <param name="Annotations">Texts and points after full expansion, by type.</param>
/// <param name="TextSteps">Texts, and the inserts that lead to them; 0 when there is no text in it.</param>
/// <param name="ConstructionSteps">Counts of construction (a type on a layer), and the inserts that lead to them; 0 when there is none in it.</param>
internal sealed record BlockWeight(long Curves, long Steps, bool HasUnfollowedInserts, IReadOnlyDictionary<string, long> Annotations, long TextSteps, long ConstructionSteps)
{
    public const long Max = long.MaxValue / 4;

    /// <summary>Points, and the inserts that lead to them; 0 when there is no point in it.</summary>
    public long PointSteps { get; init; }

    /// <summary>Copies of blocks in it, at any depth.</summary>
    public long Inserts { get; init; }

    public static long Sum(long left, long right) => Math.Min(left + right, Max);

    /// <summary>Copies times an amount, at most <see cref="Max"/>; copies are at most 32767 x 32767.</summary>
    public static long Times(long copies, long amount) => amount > Max / copies ? Max : copies * amount;
}
