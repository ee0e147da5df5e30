namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>A change of a <see cref="Tour"/> that the search found.</summary>
/// <param name="A">First node: of the part that moves, or before the part that is reversed.</param>
/// <param name="B">Last node of the part that moves, or the first of the reversed part.</param>
/// <param name="C">The node behind which a part is put, or the last of the reversed part.</param>
/// <param name="D">The node behind the reversed part, or the entry of a single node.</param>
/// <param name="Gain">By how much the cost decreases.</param>
internal readonly record struct TourChange(TourChangeKind Kind, int A, int B, int C, int D, double Gain);

/// <summary>Kinds of change.</summary>
internal enum TourChangeKind : byte
{
    None,

    /// <summary>A node is entered at another place.</summary>
    Entry,

    /// <summary>The part from B to C is reversed: 2-opt.</summary>
    Reverse,

    /// <summary>The part from position A to B is reversed as far as the required order allows.</summary>
    ReverseOrdered,

    /// <summary>A single node moves and is entered at another place.</summary>
    MoveOne,

    /// <summary>A part moves: Or-opt, and the move of a contour with everything it encloses.</summary>
    Move,

    /// <summary>A part moves and is reversed.</summary>
    MoveTurned,

    /// <summary>Two adjacent parts change places: Or-3opt.</summary>
    Swap,
}
