using System.Runtime.InteropServices;

namespace Engraver.Workbench.Plots;

/// <summary>Collects the samples of a planned motion. Above a maximum number only two samples of each group are kept, those of the highest speed and of the
/// largest acceleration, so that peaks remain.</summary>
/// <param name="maxSamples">At least 8.</param>
internal sealed class SeriesBuilder(int maxSamples)
{
    /// <summary>Number of stored samples that are merged to two at a time.</summary>
    private const int Merged = 4;

    private readonly List<PlannedSample> _samples = [];
    private readonly List<PlannedSample> _group = [];

    /// <summary>Number of samples of which two are kept; 1 while all are kept.</summary>
    private int _groupSize = 1;

    /// <summary>The first and the last sample, which are kept in any case: they are the ends of the axis.</summary>
    private PlannedSample _first;
    private PlannedSample _last;

    /// <summary>Adds a sample, unless it equals the one before.</summary>
    public void Add(in PlannedSample sample)
    {
        var before = _groupSize == 1 ? _samples : _group;
        if (before.Count > 0 && before[^1] == sample) return;
        if (_samples.Count == 0 && _group.Count == 0) _first = sample;
        _last = sample;
        before.Add(sample);
        if (_group.Count == _groupSize && _groupSize > 1) Flush();
        if (_samples.Count >= maxSamples) Thin();
    }

    public MotionSeries ToSeries()
    {
        if (_group.Count > 0) Flush();
        if (_samples.Count > 0 && _samples[0] != _first) _samples.Insert(0, _first);
        if (_samples.Count > 0 && _samples[^1] != _last) _samples.Add(_last);
        var count = _samples.Count;
        var (seconds, path, entities, speed, x, y) = (new double[count], new double[count], new int[count], new double[count], new double[count], new double[count]);
        for (var i = 0; i < count; i++) (seconds[i], path[i], entities[i], speed[i], x[i], y[i], _) = _samples[i];
        List<(PlotQuantity, double[])> values = [(PlotQuantity.Speed, speed), (PlotQuantity.AccelerationX, x), (PlotQuantity.AccelerationY, y)];
        if (_samples.Exists(sample => !double.IsNaN(sample.LinkLoad))) values.Add((PlotQuantity.LinkLoad, [.. _samples.Select(sample => sample.LinkLoad)]));
        return new MotionSeries(seconds, path, entities, values);
    }

    private void Flush()
    {
        var (first, second) = Peaks(CollectionsMarshal.AsSpan(_group));
        _samples.Add(first);
        if (second != first) _samples.Add(second);
        _group.Clear();
    }

    private void Thin()
    {
        var all = CollectionsMarshal.AsSpan(_samples);
        var kept = 0;
        for (var i = 0; i < all.Length; i += Merged)
        {
            var (first, second) = Peaks(all[i..Math.Min(i + Merged, all.Length)]);
            (all[kept], all[kept + 1]) = (first, second);
            kept += 2;
        }

        _samples.RemoveRange(kept, _samples.Count - kept);
        _groupSize = _groupSize == 1 ? Merged : 2 * _groupSize;
    }

    /// <summary>The sample of the highest speed and the one of the largest acceleration, in the order of time.</summary>
    private static (PlannedSample First, PlannedSample Second) Peaks(ReadOnlySpan<PlannedSample> group)
    {
        var (fastest, steepest) = (0, 0);
        for (var i = 1; i < group.Length; i++)
        {
            if (group[i].Speed > group[fastest].Speed) fastest = i;
            if (group[i].LargestAcceleration > group[steepest].LargestAcceleration) steepest = i;
        }

        return (group[Math.Min(fastest, steepest)], group[Math.Max(fastest, steepest)]);
    }
}
