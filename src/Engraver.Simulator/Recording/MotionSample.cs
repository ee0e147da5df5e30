namespace Engraver.Simulator;

/// <summary>Axis positions at one sample: commanded positions in counts, for a stepper the position of its shaft, and the outputs 1 to 8 as a byte (bit 0 =
/// output 1).</summary>
/// <param name="Sample">Sample number since power up; its time is Sample times 1 ms nominal.</param>
public readonly record struct MotionSample(long Sample, int A, int B, int C, int D, byte Outputs)
{
    /// <summary>Nominal controller time in seconds.</summary>
    public double Seconds => Sample / 1000.0;

    /// <summary>Commanded minus motor position of the first four axes (_TE), counts; 0 in a span, where the motors follow without lag.</summary>
    public (int A, int B, int C, int D) Error { get; init; }

    /// <summary>The following error of an axis, counts; the index of A is 0.</summary>
    public int ErrorOf(int axis) => axis switch { 0 => Error.A, 1 => Error.B, 2 => Error.C, 3 => Error.D, _ => 0 };

    /// <summary>The position of an axis, counts; the index of A is 0.</summary>
    public int this[int axis] => axis switch { 0 => A, 1 => B, 2 => C, 3 => D, _ => 0 };
}
