namespace Engraver.Core.Offsets;

/// <summary>Shape of an offset at the outside of a corner.</summary>
public enum OffsetJoin
{
    /// <summary>An arc about the corner: every point of the offset has the exact distance.</summary>
    Round,

    /// <summary>Both sides are extended straight until they meet; a bevel when they would meet beyond the limit.</summary>
    Mitre,

    /// <summary>A straight line from side to side, nearer to the corner than the distance.</summary>
    Bevel,
}
