namespace Engraver.Workbench.SerialTexts;

/// <summary>The CSV file of a series.</summary>
/// <param name="File">Its path.</param>
public sealed record PlateCsv(string File, CsvTable Table);
