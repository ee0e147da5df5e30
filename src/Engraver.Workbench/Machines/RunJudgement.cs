using Engraver.Core.Geometry;

namespace Engraver.Workbench.Machines;

/// <summary>What a run is worth, by what the controller or the simulator's record says; null where nothing is known.</summary>
/// <param name="MaxDeviationMm">Largest distance of a cutting sample from the drawing.</param>
/// <param name="MissingLengthMm">Drawn length that was never cut; null too when the link was lost and the controller went on alone.</param>
/// <param name="Source">"record", "polled" or "none".</param>
public sealed record RunJudgement(double? MaxDeviationMm, double? MissingLengthMm, string Source)
{
    public static RunJudgement Unknown { get; } = new(null, null, "none");

    /// <summary>Where on the drawing the machine was furthest from it, millimetres; null where that is not known.</summary>
    public Point2D? DeviationAt { get; init; }

    /// <summary>The first place of the drawing that was never cut, millimetres; null where nothing is missing or nobody knows where.</summary>
    public Point2D? MissingAt { get; init; }
}
