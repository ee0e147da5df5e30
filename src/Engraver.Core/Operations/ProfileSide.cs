namespace Engraver.Core.Operations;

/// <summary>Side of a profile.</summary>
public enum ProfileSide
{
    /// <summary>Outside of outer contours, inside of holes, alternating at each nesting level.</summary>
    Nesting,
    Outside,
    Inside,

    /// <summary>Left of the drawn direction.</summary>
    Left,

    /// <summary>Right of the drawn direction.</summary>
    Right,
}
