namespace Engraver.Core.Operations;

/// <summary>Direction of a lead that is a line.</summary>
public enum LeadDirection
{
    /// <summary>At right angles to the contour.</summary>
    Perpendicular,

    /// <summary>In line with the contour.</summary>
    Tangential,
}
