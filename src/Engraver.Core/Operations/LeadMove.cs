namespace Engraver.Core.Operations;

/// <summary>A move to a contour, or away from it, in the waste beside it.</summary>
/// <param name="Shape">Its shape.</param>
/// <param name="Length">Radius of the arc, or length of the line, mm; shortened where it would meet a part.</param>
public sealed record LeadMove(LeadShape Shape, double Length)
{
    /// <summary>Direction of a line.</summary>
    public LeadDirection Direction { get; init; }
}
