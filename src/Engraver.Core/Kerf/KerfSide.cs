namespace Engraver.Core.Kerf;

/// <summary>The side of the drawn contours on which the tool runs.</summary>
public enum KerfSide
{
    /// <summary>On the line.</summary>
    Off,

    /// <summary>Outermost contours on their outside, holes on their inside, and so on in turn: the part gets the drawn size.</summary>
    Nesting,

    /// <summary>Every closed contour on its outside, independently of the others.</summary>
    Outside,

    /// <summary>Every closed contour on its inside, independently of the others.</summary>
    Inside,

    /// <summary>To the left of the direction in which each contour was drawn.</summary>
    Left,

    /// <summary>To the right of it.</summary>
    Right,
}
