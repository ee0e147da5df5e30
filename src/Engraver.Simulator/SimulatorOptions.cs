namespace Engraver.Simulator;

/// <summary>How the simulated DMC-2143 behaves. Every open point of the reference ([U], [U-] in galil-dmc.md) that we can vary is a setting here.</summary>
public sealed record SimulatorOptions
{
    /// <summary>Controller seconds per wall second: 1 is real time, <see cref="double.PositiveInfinity"/> is virtual time ("max").</summary>
    public double Speed { get; init; } = 1;

    /// <summary>Connections the controller can hold, 1 to 8 (galil-dmc.md A.1: 6 or 8 on a 21x3, not confirmed).</summary>
    public int HandleCount { get; init; } = 8;

    /// <summary>Resolution of the CR angles in degrees (galil-dmc.md B.3: 1/65536 or 1/256); 0 keeps them as given.</summary>
    public double AngleQuantumDegrees { get; init; } = 1.0 / 65536;

    /// <summary>Resolution of the CR radius in counts, truncated (galil-dmc.md B.3); 0 keeps it real.</summary>
    public double RadiusQuantum { get; init; } = 1;

    /// <summary>Virtual time that one host command takes at speed max (galil-dmc.md A.4).</summary>
    public TimeSpan CommandCost { get; init; } = TimeSpan.FromMilliseconds(1.6);

    /// <summary>Controller time that one command of a running program takes (galil-dmc.md A.4, I.8).</summary>
    public TimeSpan LineCost { get; init; } = TimeSpan.FromMilliseconds(0.5);

    /// <summary>Lines of program memory (galil-dmc.md 0.3).</summary>
    public int ProgramLines { get; init; } = 1000;

    /// <summary>What ^R^V answers (galil-dmc.md I.6).</summary>
    public string Model { get; init; } = "DMC2143 Rev 1.0o";

    /// <summary>Whether automatic subroutines need a running thread 0 (galil-dmc.md C.3, [U]).</summary>
    public bool HandlersNeedThreadZero { get; init; } = true;

    /// <summary>The wall clock and its timers.</summary>
    public TimeProvider Time { get; init; } = TimeProvider.System;

    /// <summary>What shall go wrong on purpose; null is a healthy controller.</summary>
    public FaultPlan? Faults { get; init; }

    /// <summary>True when time is virtual ("max").</summary>
    public bool IsVirtual => double.IsPositiveInfinity(Speed);
}
