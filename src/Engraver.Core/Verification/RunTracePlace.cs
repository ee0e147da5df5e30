using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>One place of a run.</summary>
/// <param name="Seconds">Controller time.</param>
/// <param name="Place">Position in millimetres of the drawing.</param>
/// <param name="ToolOn">True when the tool output was on.</param>
/// <param name="DeviationMm">Distance from the drawing while the tool was on; 0 while it was off.</param>
/// <param name="FollowingMm">Distance of the motors from their commanded positions, millimetres; null when not recorded.</param>
public readonly record struct RunTracePlace(double Seconds, Point2D Place, bool ToolOn, double DeviationMm, double? FollowingMm = null)
{
    /// <summary>Feed override and load of the link at this place.</summary>
    public TraceConditions Conditions { get; init; }
}
