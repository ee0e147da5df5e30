using System.Globalization;

namespace Engraver.Benchmarks.Motion;

/// <summary>The largest acceleration while the tool is on in a record of the simulated motors (<c>engraver simulate --record</c>): second differences of the
/// positions over a time in which whole counts can show an acceleration.</summary>
internal sealed class RecordedAcceleration
{
    private const double Sample = 0.001;

    /// <summary>At rest the record has no rows; a longer gap separates two motions, samples.</summary>
    private const int LongestGap = 200;

    private readonly List<(long Sample, double X, double Y, bool IsOn)> _rows = [];

    /// <param name="acceleration">Of the machine, counts/s2.</param>
    /// <returns>Largest acceleration, its place in counts, and the largest that the plan and the rounding to counts allow; counts/s2.</returns>
    public static (double Largest, double X, double Y, double Allowed) Of(string record, double acceleration)
    {
        var read = new RecordedAcceleration();
        foreach (var line in File.ReadLines(record).Skip(1)) read.Add(line.Split(','));
        return read.Largest(acceleration);
    }

    private void Add(string[] cells)
    {
        double Number(int cell) => double.Parse(cells[cell], CultureInfo.InvariantCulture);
        var row = (Sample: (long)Math.Round(Number(0) / Sample), X: Number(1), Y: Number(2), IsOn: ((int)Number(5) & 1) != 0);
        if (_rows.Count > 0 && _rows[^1].Sample == row.Sample) _rows.RemoveAt(_rows.Count - 1);
        while (_rows.Count > 0 && row.Sample - _rows[^1].Sample is > 1 and < LongestGap) _rows.Add(_rows[^1] with { Sample = _rows[^1].Sample + 1 });
        _rows.Add(row);
    }

    private (double Largest, double X, double Y, double Allowed) Largest(double acceleration)
    {
        var span = (int)Math.Ceiling(Math.Sqrt(20.0 / acceleration) / Sample);
        var seconds = span * Sample;
        var (largest, x, y) = (0.0, 0.0, 0.0);
        for (var i = span; i < _rows.Count - span; i++)
        {
            var (before, at, after) = (_rows[i - span], _rows[i], _rows[i + span]);
            if (after.Sample - before.Sample != 2 * span || !before.IsOn || !at.IsOn || !after.IsOn) continue;
            var found = double.Hypot(before.X - (2.0 * at.X) + after.X, before.Y - (2.0 * at.Y) + after.Y) / (seconds * seconds);
            if (found > largest) (largest, x, y) = (found, at.X, at.Y);
        }

        return (largest, x, y, (1.05 * acceleration) + (2.0 / (seconds * seconds)));
    }
}
