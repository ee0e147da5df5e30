namespace Engraver.Core.Machines;

/// <summary>How the tool is brought to the work and taken away at one stroke, where its operation states it.</summary>
/// <param name="PlungeSpeed">Speed of the tool's axis down to the work, counts/s.</param>
/// <param name="PierceSeconds">Time between the tool at work and the first move, after its settle time.</param>
/// <param name="DwellSeconds">Time at the end of the last move before the tool is taken away.</param>
public sealed record StrokeTerms(int PlungeSpeed, double PierceSeconds, double DwellSeconds)
{
    /// <summary>The longer of both waits, seconds.</summary>
    public double LongestWait => Math.Max(PierceSeconds, DwellSeconds);
}
