namespace Engraver.Workbench.SerialTexts;

/// <summary>A plate whose numbers are spent and not confirmed.</summary>
public sealed record StartedPlate
{
    /// <summary>Names it in the book.</summary>
    public required string Id { get; init; }

    /// <summary>True: its numbers were left out (<see cref="CounterChoice.Next"/>). It can still be resumed.</summary>
    public bool IsLeftOut { get; init; }

    /// <summary>Its number of each counter.</summary>
    public required IReadOnlyDictionary<string, long> Numbers { get; init; }

    /// <summary>All its values, for people (<see cref="PlateValues.ToString"/>).</summary>
    public required string Values { get; init; }

    /// <summary>Full path of the drawing.</summary>
    public required string Drawing { get; init; }

    /// <summary>Full path of the journal of its run.</summary>
    public required string Journal { get; init; }

    public required DateTimeOffset Date { get; init; }

    /// <summary>Whether it is of this drawing.</summary>
    public bool IsOf(string drawing) => Drawing == Path.GetFullPath(drawing);

    /// <summary>Whether it has a row of a CSV file.</summary>
    internal bool HasAnyRow => Values.Contains(PlateValues.RowWord, StringComparison.Ordinal);

    /// <summary>Whether its values end with this row (<see cref="PlateValues.ToString"/>): number and values are the same.</summary>
    internal bool HasRow(CsvRow row)
    {
        var text = new PlateValues { Row = row }.ToString();
        return Values == text || Values.EndsWith(", " + text, StringComparison.Ordinal);
    }

    internal bool Has(string counter, long number) => Numbers.Any(one => one.Key.Equals(counter, StringComparison.OrdinalIgnoreCase) && one.Value == number);
}
