namespace Engraver.Workbench.SerialTexts;

/// <summary>A row of a CSV file.</summary>
/// <param name="Number">1 is the first row below the header; empty lines do not count.</param>
/// <param name="Columns">In the order of the header.</param>
public sealed record CsvRow(int Number, IReadOnlyList<CsvValue> Columns)
{
    /// <summary>Null where there is no such column; upper and lower case are the same.</summary>
    public string? Find(string column) => Columns.FirstOrDefault(one => one.Column.Equals(column, StringComparison.OrdinalIgnoreCase))?.Value;

    public bool Equals(CsvRow? other) => other is not null && Number == other.Number && Columns.SequenceEqual(other.Columns);

    public override int GetHashCode() => HashCode.Combine(Number, Columns.Count);
}

/// <param name="Value">Without the quotes of the file.</param>
public sealed record CsvValue(string Column, string Value);
