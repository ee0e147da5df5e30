namespace Engraver.Core.Machines;

/// <summary>How the tool is brought to the work and taken away at one stroke, where its operation states it.</summary>
/// <param name="PlungeSpeed">Speed of the tool's axis down to the work, counts/s.</param>
/// <param name="PierceSeconds">Time between the tool at work and the first move, after its settle time.</param>
/// <param name="DwellSeconds">Time at the end of the last move before the tool is taken away.</param>
public sealed record StrokeTerms(int PlungeSpeed, double PierceSeconds, double DwellSeconds)
{
    /// <summary>Outputs that operations of the job switch; bit 0 is output 1.</summary>
    public int Outputs { get; init; }

    /// <summary>Those of them that are on for this stroke.</summary>
    public int OutputsOn { get; init; }

    /// <summary>Volts of the analog output that sets the speed of the spindle or the power of the beam; null: as at the start of the job.</summary>
    public double? Volts { get; init; }

    /// <summary>Time after the outputs are set and before the machine moves to the stroke, seconds: until the spindle has its speed.</summary>
    public double ReadySeconds { get; init; }

    /// <summary>Outputs are set before the machine moves to the stroke.</summary>
    public bool SetsOutputs => Outputs != 0 || Volts is not null;

    /// <summary>The longest of its waits, seconds.</summary>
    public double LongestWait => Math.Max(ReadySeconds, Math.Max(PierceSeconds, DwellSeconds));
}
