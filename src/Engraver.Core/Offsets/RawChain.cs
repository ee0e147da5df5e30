using Engraver.Core.Offsets.Pieces;

namespace Engraver.Core.Offsets;

/// <summary>A closed chain whose left side is offset: a side of a closed contour, or both sides of an open one, there and back.</summary>
/// <param name="Pieces">Each starts where the previous one ends, the first at the end of the last.</param>
/// <param name="Sources">The source segment of each piece.</param>
/// <param name="Forwards">Number of pieces in the drawn direction; the others run back.</param>
/// <param name="IsOpen">An open contour, which turns back at its two ends.</param>
internal sealed record RawChain(PathPiece[] Pieces, OffsetSource[] Sources, int Forwards, bool IsOpen, double Smoothness)
{
    /// <summary>The left side of a closed contour.</summary>
    public static RawChain LeftOf(SourceChain chain) => new(chain.Pieces, chain.Sources, chain.Pieces.Length, false, chain.Smoothness);

    /// <summary>The right side of a closed contour.</summary>
    public static RawChain RightOf(SourceChain chain)
    {
        var reversed = chain.Reversed();
        return new RawChain(reversed.Pieces, reversed.Sources, 0, false, chain.Smoothness);
    }

    /// <summary>Both sides of an open contour.</summary>
    public static RawChain Around(SourceChain chain)
    {
        var reversed = chain.Reversed();
        return new RawChain([.. chain.Pieces, .. reversed.Pieces], [.. chain.Sources, .. reversed.Sources], chain.Pieces.Length, true, chain.Smoothness);
    }

    public RawSides SideOf(int piece) => piece < Forwards ? RawSides.Left : RawSides.Right;

    /// <summary>True where an open contour ends: the offset runs around this end.</summary>
    public bool IsCapBehind(int piece) => IsOpen && (piece == Forwards - 1 || piece == Pieces.Length - 1);
}
