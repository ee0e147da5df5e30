using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The plates of a run, in their order.</summary>
/// <param name="Rows">For each plate its row; null without a CSV file.</param>
/// <param name="Grid">Null: one plate on a blank.</param>
public sealed record PlateSeries(PlateFields Fields, IReadOnlyList<CsvRow?> Rows, PlateGrid? Grid)
{
    public int Count => Rows.Count;

    /// <summary>Names of the work origins at which the plates are engraved, each with all cells of the grid, in this order; empty: the active one.</summary>
    public IReadOnlyList<string> Fixtures { get; init; } = [];

    /// <summary>Index of the cell of the first plate, counted through all fixtures: the cells before it are done. 0 for one plate on a blank.</summary>
    public int FirstCell { get; init; }

    /// <summary>Number of cells of all fixtures.</summary>
    public int Cells => (Grid?.Cells ?? 1) * Math.Max(1, Fixtures.Count);

    /// <summary>Index of the cell of a plate, counted through all fixtures; after the last cell the next blank begins.</summary>
    public int CellOf(int index) => (FirstCell + index) % Cells;

    /// <summary>The place of a plate on its blank, millimetres.</summary>
    public Vector2D OffsetOf(int index) => Grid?.OffsetOf(CellOf(index)) ?? default;

    /// <summary>The work origin of a plate; null: the active one.</summary>
    public string? FixtureOf(int index) => Fixtures.Count == 0 ? null : Fixtures[CellOf(index) / (Grid?.Cells ?? 1)];

    /// <summary>Whether a plate of a journal is the one with this index, by its place.</summary>
    public bool IsPlaceOf(Plate plate, int index)
    {
        ArgumentNullException.ThrowIfNull(plate);
        return index < Count && plate.Offset == OffsetOf(index) && plate.Fixture == FixtureOf(index);
    }

    /// <summary>Where a series with a CSV file begins after plates that were not finished: with their rows, because these are not engraved yet and the rows
    /// before them are. With <see cref="CounterChoice.Again"/> each row gets the number it had.</summary>
    /// <param name="unfinished">The plates with the counters of this series, the oldest first.</param>
    /// <param name="drawing">The file that is engraved.</param>
    /// <param name="isSelected">The operator selected the rows: a row that is not among them is left out, if its number is.</param>
    /// <returns>The index of the first plate.</returns>
    /// <exception cref="CounterException">The row of an unfinished plate is not in this series, or not in its place.</exception>
    public int FirstAfter(IReadOnlyList<StartedPlate> unfinished, CounterChoice choice, string drawing, bool isSelected)
    {
        ArgumentNullException.ThrowIfNull(unfinished);
        var found = unfinished.Select(plate => (Plate: plate, Index: IndexOf(plate))).ToList();
        if (choice == CounterChoice.Next)
        {
            found.RemoveAll(one => one.Index < 0 && (isSelected || !one.Plate.HasAnyRow || !one.Plate.IsOf(drawing)));
            found.Sort((one, other) => one.Index.CompareTo(other.Index));
        }

        if (found.Count == 0) return 0;
        var first = found[0].Index;
        for (var i = 0; i < found.Count && (i == 0 || first + i < Count || choice == CounterChoice.Next); i++)
        {
            var hasNumbers = i == 0 || choice == CounterChoice.Next || Fields.Counters.All(counter => found[i].Plate.Numbers.Keys.Any(name => CounterDocument.IsSame(name, counter.Name)));
            if (found[i].Index < 0 || found[i].Index != first + i || !hasNumbers) throw new CounterException(SerialRules.RowNotInSeries.At(default, found[i].Plate.Values, found[i].Plate.Journal));
        }

        return first;
    }

    /// <summary>The plate with this index.</summary>
    /// <param name="numbers">Its number of each counter.</param>
    public Plate At(int index, IReadOnlyDictionary<string, long> numbers, DateTimeOffset now) => new(index + 1, Fields.ValuesOf(Rows[index], numbers, now, index + 1), OffsetOf(index)) { Fixture = FixtureOf(index) };

    /// <summary>True if another blank must be placed before this plate.</summary>
    public bool StartsBlank(int index) => index > 0 && CellOf(index) == 0;

    /// <summary>The problems of all plates: each finding once.</summary>
    public IReadOnlyList<Diagnostic> Check(IEnumerable<Plate> plates) => [.. plates.SelectMany(plate => Fields.Check(plate.Values)).DistinctBy(finding => (finding.Source, finding.Message))];

    /// <summary>The index of the plate with the row of a plate that was started; -1 if no row is the same.</summary>
    private int IndexOf(StartedPlate started) => Rows.ToList().FindIndex(row => row is not null && started.HasRow(Fields.Used(row)));
}
