namespace Engraver.Workbench.Plots;

/// <summary>A motion as columns: planned, or recorded from a machine. Immutable.</summary>
public sealed class MotionSeries
{
    private readonly double[]?[] _values;
    private readonly IReadOnlyList<Range>?[] _known;
    private readonly (double Low, double High)?[] _extremes;

    /// <param name="seconds">Time of each sample since the start of the motion; never decreases.</param>
    /// <param name="path">Length of the path travelled until each sample, with the tool on or off, mm; never decreases.</param>
    /// <param name="entities">Drawing entity at each sample, -1 for none; null if unknown.</param>
    /// <param name="values">The known quantities, one value for each sample; NaN where a value is unknown.</param>
    internal MotionSeries(double[] seconds, double[] path, int[]? entities, params IEnumerable<(PlotQuantity Quantity, double[] Values)> values)
    {
        (Seconds, Path, Entities) = (seconds, path, entities);
        var count = Enum.GetValues<PlotQuantity>().Length;
        (_values, _known, _extremes) = (new double[]?[count], new IReadOnlyList<Range>?[count], new (double, double)?[count]);
        foreach (var (quantity, known) in values)
        {
            if (known.Length != seconds.Length) throw new ArgumentException("Columns of different lengths.", nameof(values));
            _values[(int)quantity] = known;
        }
    }

    public int Count => Seconds.Length;

    /// <summary>Time of each sample, seconds; never decreases. Two samples of one time are the values before and after a jump.</summary>
    public double[] Seconds { get; }

    /// <summary>Length of the path travelled until each sample, mm; never decreases.</summary>
    public double[] Path { get; }

    /// <summary>Drawing entity at each sample, -1 for none; null if unknown.</summary>
    public int[]? Entities { get; }

    /// <summary>The values of a quantity, NaN where unknown; null if nothing is known of it.</summary>
    public double[]? Of(PlotQuantity quantity) => _values[(int)quantity];

    /// <summary>The samples along an axis of the plots.</summary>
    public double[] Along(PlotAxis axis) => axis == PlotAxis.Time ? Seconds : Path;

    /// <summary>The last sample at or before a place of an axis; 0 before the first, -1 when there is none.</summary>
    public int SampleAt(PlotAxis axis, double place)
    {
        if (Count == 0) return -1;
        var (column, low, high) = (Along(axis), 0, Count - 1);
        while (low < high)
        {
            var middle = (low + high + 1) / 2;
            if (column[middle] <= place) low = middle;
            else high = middle - 1;
        }

        return low;
    }

    /// <summary>The place on one axis where the motion is at a place of the other, interpolated between samples.</summary>
    public double Convert(PlotAxis from, double place, PlotAxis to)
    {
        if (from == to || Count == 0) return place;
        var (column, other, at) = (Along(from), Along(to), SampleAt(from, place));
        if (at + 1 >= Count || place <= column[at]) return other[at];
        return other[at] + ((place - column[at]) / (column[at + 1] - column[at]) * (other[at + 1] - other[at]));
    }

    /// <summary>The value of a quantity at a place of an axis, interpolated between samples; NaN where it is unknown and outside the motion.</summary>
    public double ValueAt(PlotQuantity quantity, PlotAxis axis, double place)
    {
        if (Of(quantity) is not { } values || Count == 0) return double.NaN;
        var (column, at) = (Along(axis), SampleAt(axis, place));
        if (place < column[0] || place > column[^1]) return double.NaN;
        if (at + 1 >= Count || place <= column[at]) return values[at];
        return values[at] + ((place - column[at]) / (column[at + 1] - column[at]) * (values[at + 1] - values[at]));
    }

    /// <summary>The contiguous ranges of samples at which a quantity is known.</summary>
    public IReadOnlyList<Range> KnownRanges(PlotQuantity quantity) => _known[(int)quantity] ??= FindKnown(Of(quantity));

    /// <summary>The smallest and the largest known value of a quantity; both 0 if none is known.</summary>
    public (double Low, double High) Extremes(PlotQuantity quantity) => _extremes[(int)quantity] ??= FindExtremes(Of(quantity));

    private static List<Range> FindKnown(double[]? values)
    {
        var (ranges, start) = (new List<Range>(), -1);
        for (var i = 0; values is not null && i <= values.Length; i++)
        {
            var isKnown = i < values.Length && !double.IsNaN(values[i]);
            if (isKnown && start < 0) start = i;
            if (isKnown || start < 0) continue;
            ranges.Add(start..i);
            start = -1;
        }

        return ranges;
    }

    private static (double Low, double High) FindExtremes(double[]? values)
    {
        var (low, high) = (double.PositiveInfinity, double.NegativeInfinity);
        foreach (var value in values ?? [])
        {
            if (value < low) low = value;
            if (value > high) high = value;
        }

        return low <= high ? (low, high) : (0.0, 0.0);
    }
}
