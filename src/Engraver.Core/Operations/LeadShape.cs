namespace Engraver.Core.Operations;

/// <summary>Shape of a lead.</summary>
public enum LeadShape
{
    /// <summary>A quarter of a circle that ends in the direction of the contour.</summary>
    Arc,

    /// <summary>A straight line.</summary>
    Line,
}
