using System.Net;

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

    /// <summary>What stands before a negative number that follows another one in a message (galil-dmc.md A.3: differs from page to page).</summary>
    public NumberSpacing NumberSpacing { get; init; }

    /// <summary>Lines of program memory (galil-dmc.md 0.3).</summary>
    public int ProgramLines { get; init; } = 1000;

    /// <summary>Contour records that can wait behind the one being executed (galil-dmc.md C.4): 1 as on older controllers, whose programs wait with WC, or 511 as on newer ones.</summary>
    public int ContourRecords { get; init; } = 1;

    /// <summary>What ^R^V answers (galil-dmc.md I.6).</summary>
    public string Model { get; init; } = "DMC2143 Rev 1.0o";

    /// <summary>What _BN answers: the serial number of the processor board (galil-dmc.md 0.3).</summary>
    public int SerialNumber { get; init; } = 2143;

    /// <summary>Whether automatic subroutines need a running thread 0 (galil-dmc.md C.3, [U]).</summary>
    public bool HandlersNeedThreadZero { get; init; } = true;

    /// <summary>Time constant of the servo lag: how far the motors stay behind their command (galil-dmc.md I.14); zero is a perfect motor.</summary>
    public TimeSpan ServoLag { get; init; }

    /// <summary>Where limit switches, home switches and index pulses lie; axes left out have switches only as far as they are set by hand, and an index every 4000 counts.</summary>
    public IReadOnlyList<AxisSwitches> Switches { get; init; } = [];

    /// <summary>Speeds and accelerations at power up; null for the factory's.</summary>
    public BurnedMotion? Burned { get; init; }

    /// <summary>Where program messages go after power up: A to H, or S for the serial port (CF, galil-dmc.md A.5).</summary>
    public char MessagePort { get; init; } = 'S';

    /// <summary>Whether messages carry bit 7 after power up: 1 yes, 2 no (CW, galil-dmc.md A.5).</summary>
    public int MessageMarking { get; init; } = 2;

    /// <summary>The address that TH and _IA0 tell; the controller listens on loopback whatever it is.</summary>
    public IPAddress Address { get; init; } = IPAddress.Loopback;

    /// <summary>Whether <see cref="SimulatedController.Record"/> keeps its rows. Without, its listeners and its file are told all the same, and memory does not grow with machine time.</summary>
    public bool KeepsRecord { get; init; } = true;

    /// <summary>Whether samples of constant speed in which nothing else can happen are jumped over instead of being stepped; what happens is the same to the last bit.</summary>
    public bool JumpsSteadyMotion { get; init; } = true;

    /// <summary>The wall clock and its timers.</summary>
    public TimeProvider Time { get; init; } = TimeProvider.System;

    /// <summary>What shall go wrong on purpose; null is a healthy controller.</summary>
    public FaultPlan? Faults { get; init; }

    /// <summary>True when time is virtual ("max").</summary>
    public bool IsVirtual => double.IsPositiveInfinity(Speed);
}

/// <summary>What divides two numbers of one message (galil-dmc.md A.3).</summary>
public enum NumberSpacing
{
    /// <summary>A blank, whatever the sign of the second: <c>20000.0000 -81.0000</c>.</summary>
    Blank,

    /// <summary>The column of the sign and nothing else, so that a minus follows the last digit: <c>20000.0000-81.0000</c>.</summary>
    SignColumn,
}
