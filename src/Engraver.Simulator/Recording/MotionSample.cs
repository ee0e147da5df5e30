namespace Engraver.Simulator;

/// <summary>Where the axes stood at one sample: commanded positions in counts and the outputs 1 to 8 as a byte (bit 0 = output 1).</summary>
/// <param name="Sample">Sample number since power up; its time is Sample times 1 ms nominal.</param>
public readonly record struct MotionSample(long Sample, int A, int B, int C, int D, byte Outputs)
{
    /// <summary>Nominal controller time in seconds.</summary>
    public double Seconds => Sample / 1000.0;
}
