namespace Engraver.Core.Plots;

/// <summary>Meaning of the colours of a run, in words.</summary>
/// <param name="Caption">The quantity shown and its source.</param>
/// <param name="Min">The value of the first colour.</param>
/// <param name="Max">The value of the last colour.</param>
public sealed record PlotHeat(string Caption, string Min, string Max);
