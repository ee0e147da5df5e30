namespace Engraver.Core.Offsets.Graphs;

/// <summary>A part of a piece between two nodes.</summary>
/// <param name="Piece">Number of the piece.</param>
/// <param name="From">Fraction of the piece at which it begins.</param>
/// <param name="To">Fraction at which it ends; less than <paramref name="From"/> when the edge runs against its piece.</param>
/// <param name="Start">Node at its start.</param>
/// <param name="End">Node at its end; for a whole circle the same.</param>
internal readonly record struct GraphEdge(int Piece, double From, double To, int Start, int End)
{
    public GraphEdge Reversed() => new(Piece, To, From, End, Start);
}
