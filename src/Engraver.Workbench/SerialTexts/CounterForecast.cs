using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The numbers that the next plates get.</summary>
/// <param name="Plates">For each plate its number of each counter.</param>
/// <param name="Refusal">Why no plate may be started yet; null if one may.</param>
public sealed record CounterForecast(IReadOnlyList<IReadOnlyDictionary<string, long>> Plates, Diagnostic? Refusal);
