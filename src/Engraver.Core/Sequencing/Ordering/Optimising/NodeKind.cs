namespace Engraver.Core.Sequencing.Ordering.Optimising;

/// <summary>How a node of an <see cref="OrderProblem"/> can be entered.</summary>
internal enum NodeKind : byte
{
    /// <summary>A closed contour: it ends at the place where it starts, one of several.</summary>
    Closed,

    /// <summary>An open contour: it starts at either of its two places and ends at the other.</summary>
    Open,

    /// <summary>An open contour with only one allowed direction, or the tool between its last stroke and its first.</summary>
    Directed,
}
