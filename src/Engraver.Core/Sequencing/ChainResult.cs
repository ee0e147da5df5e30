namespace Engraver.Core.Sequencing;

/// <summary>What chaining found.</summary>
/// <param name="Contours">In order of their lowest row.</param>
/// <param name="Discontinuities">Two for every open contour, start before end, in contour order.</param>
/// <param name="Branches">Times a contour had to choose between several continuations.</param>
public sealed record ChainResult(IReadOnlyList<Contour> Contours, IReadOnlyList<Discontinuity> Discontinuities, int Branches)
{
    /// <summary>How many segment ends, and boxes of them, were looked at: what chaining cost.</summary>
    public long Looks { get; init; }
}
