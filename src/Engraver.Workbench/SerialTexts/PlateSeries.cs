using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The plates of a run, in their order.</summary>
/// <param name="Rows">For each plate its row; null without a CSV file.</param>
/// <param name="Grid">Null: one plate on a blank.</param>
public sealed record PlateSeries(PlateFields Fields, IReadOnlyList<CsvRow?> Rows, PlateGrid? Grid)
{
    public int Count => Rows.Count;

    /// <summary>The plate with this index.</summary>
    /// <param name="numbers">Its number of each counter.</param>
    public Plate At(int index, IReadOnlyDictionary<string, long> numbers, DateTimeOffset now) => new(index + 1, Fields.ValuesOf(Rows[index], numbers, now, index + 1), Grid?.OffsetOf(index) ?? default);

    /// <summary>Every plate with the numbers of a forecast.</summary>
    public IReadOnlyList<Plate> All(CounterForecast forecast, DateTimeOffset now)
    {
        ArgumentNullException.ThrowIfNull(forecast);
        return [.. Enumerable.Range(0, Count).Select(index => At(index, forecast.Plates[index], now))];
    }

    /// <summary>True if another blank must be placed before this plate.</summary>
    public bool StartsBlank(int index) => index > 0 && index % (Grid?.Cells ?? 1) == 0;

    /// <summary>The problems of all plates: each finding once.</summary>
    public IReadOnlyList<Diagnostic> Check(IEnumerable<Plate> plates) => [.. plates.SelectMany(plate => Fields.Check(plate.Values)).DistinctBy(finding => (finding.Source, finding.Message))];
}
