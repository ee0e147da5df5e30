namespace Engraver.Core.Offsets.Graphs;

/// <summary>Whether the edges of a run bound the area.</summary>
internal enum RunUse : byte
{
    /// <summary>Both of its sides are inside, or both outside.</summary>
    None,

    /// <summary>The area is on the left.</summary>
    Forwards,

    /// <summary>The area is on the right: the run is reversed.</summary>
    Backwards,
}
