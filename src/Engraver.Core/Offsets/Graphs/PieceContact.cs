namespace Engraver.Core.Offsets.Graphs;

/// <summary>Which common points of two pieces become nodes.</summary>
internal enum PieceContact : byte
{
    /// <summary>Points where pieces cross, and the ends of common parts. Neighbours that are almost tangent meet only in their joint.</summary>
    Crossings,

    /// <summary>Also the ends of pieces that touch another piece.</summary>
    CrossingsAndEnds,
}
