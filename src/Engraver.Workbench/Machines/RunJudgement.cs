namespace Engraver.Workbench.Machines;

/// <summary>What a run is worth, by what the controller or the simulator's record says; null where nothing is known.</summary>
/// <param name="MaxDeviationMm">Largest distance of a cutting sample from the drawing.</param>
/// <param name="MissingLengthMm">Drawn length that was never cut.</param>
/// <param name="Source">"record", "polled" or "none".</param>
public sealed record RunJudgement(double? MaxDeviationMm, double? MissingLengthMm, string Source)
{
    public static RunJudgement Unknown { get; } = new(null, null, "none");
}
