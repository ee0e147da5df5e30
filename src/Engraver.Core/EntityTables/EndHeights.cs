namespace Engraver.Core.EntityTables;

/// <summary>The height (z, millimetres) at which each segment of a table begins and ends: slots 3 and 6. End number 2 x row is a segment's start, 2 x row + 1
/// its end.</summary>
/// <remarks>Heights that differ by no more than the tolerance are one level, so that the noise of real drawings (1e-10) does not separate levels. The height of
/// a level does not exceed the tolerance: the small steps of a ramp do not make one of all depths. A drawing at one level, at any height, is flat.</remarks>
public sealed class EndHeights
{
    /// <summary>Heights that differ by no more are at one place, and a level does not end between them, mm.</summary>
    private const double Noise = 1e-6;

    /// <summary>Smallest difference of heights that is a step, mm.</summary>
    private const double SmallestStep = 0.01;

    private readonly double[] _heights;
    private readonly int[] _levels;

    private EndHeights(double[] heights, int[] levels) => (_heights, _levels) = (heights, levels);

    /// <summary>Everything at one height.</summary>
    public static EndHeights Flat { get; } = new([], []);

    /// <summary>True when all ends are at one level.</summary>
    public bool AreFlat => _levels.Length == 0;

    /// <summary>Heights nearer to each other than this are equal, mm: the join tolerance, but at least <see cref="SmallestStep"/>, because a tolerance of 0 is
    /// meant for the plan.</summary>
    public static double ToleranceFor(double joinTolerance) => Math.Max(joinTolerance, SmallestStep);

    /// <summary>The heights of a table's rows.</summary>
    public static EndHeights From(EntityTable table, double joinTolerance)
    {
        ArgumentNullException.ThrowIfNull(table);
        var (low, high) = (double.PositiveInfinity, double.NegativeInfinity);
        for (var row = 0; row < table.Count; row++)
        {
            var slots = table[row];
            low = Math.Min(low, Math.Min(slots[EntitySlot.StartZ], slots[EntitySlot.EndZ]));
            high = Math.Max(high, Math.Max(slots[EntitySlot.StartZ], slots[EntitySlot.EndZ]));
        }

        return high - low > ToleranceFor(joinTolerance) ? Sorted(table, ToleranceFor(joinTolerance)) : Flat;
    }

    /// <summary>Level of an end, counted from the lowest, 0.</summary>
    public int LevelOf(int end) => AreFlat ? 0 : _levels[end];

    /// <summary>Height of an end, millimetres; 0 in a flat drawing.</summary>
    public double HeightOf(int end) => AreFlat ? 0.0 : _heights[end];

    /// <summary>Number of levels among heights in ascending order: a new one begins wherever the next is higher by more than the tolerance.</summary>
    internal static int Levels(ReadOnlySpan<double> ascending, double tolerance)
    {
        var levels = ascending.Length == 0 ? 0 : 1;
        for (var i = 1; i < ascending.Length; i++) levels += ascending[i] - ascending[i - 1] > tolerance ? 1 : 0;
        return levels;
    }

    private static EndHeights Sorted(EntityTable table, double tolerance)
    {
        var heights = new double[2 * table.Count];
        for (var row = 0; row < table.Count; row++) (heights[2 * row], heights[(2 * row) + 1]) = (table[row][EntitySlot.StartZ], table[row][EntitySlot.EndZ]);
        var ascending = heights.AsSpan().ToArray();
        var ends = new int[heights.Length];
        for (var end = 0; end < ends.Length; end++) ends[end] = end;
        Array.Sort(ascending, ends);
        var levels = new int[heights.Length];
        var lowest = ascending[0];
        for (var i = 1; i < ends.Length; i++)
        {
            var step = ascending[i] - ascending[i - 1];
            var isNext = step > tolerance || (step > Noise && ascending[i] - lowest > tolerance);
            if (isNext) lowest = ascending[i];
            levels[ends[i]] = levels[ends[i - 1]] + (isNext ? 1 : 0);
        }

        return new EndHeights(heights, levels);
    }
}
