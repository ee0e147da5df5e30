namespace Engraver.Workbench.Histories;

/// <summary>Result of reading a program back.</summary>
/// <param name="Date">Date, UTC.</param>
/// <param name="MaxDeviation">Millimetres; null when unknown.</param>
/// <param name="Certificate">Full path of its certificate; null for none.</param>
public sealed record HistoryReadBack(bool Ok, DateTimeOffset Date, double? MaxDeviation, string? Certificate);
