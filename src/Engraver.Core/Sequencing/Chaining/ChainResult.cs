namespace Engraver.Core.Sequencing.Chaining;

/// <summary>The result of chaining.</summary>
/// <param name="Contours">Contours in order of their lowest row.</param>
/// <param name="Discontinuities">Two for every open contour except those of letters, start before end, in contour order.</param>
/// <param name="Branches">Number of times a contour had several continuations.</param>
public sealed record ChainResult(IReadOnlyList<Contour> Contours, ContourEnds Discontinuities, int Branches)
{
    /// <summary>Segment ends, and boxes of them, that were tested: a measure of the work.</summary>
    public long Comparisons { get; init; }
}
