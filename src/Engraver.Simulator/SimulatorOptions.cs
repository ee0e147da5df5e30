using System.Net;

namespace Engraver.Simulator;

/// <summary>Settings of the simulated DMC-2143. Every open point of the reference ([U], [U-] in galil-dmc.md) that the simulator can vary is a setting
/// here.</summary>
public sealed record SimulatorOptions
{
    /// <summary>Controller seconds per wall second: 1 is real time, <see cref="double.PositiveInfinity"/> is virtual time ("max").</summary>
    public double Speed { get; init; } = 1;

    /// <summary>Number of handles of the controller, 1 to 8 (galil-dmc.md A.1: 6 or 8 on a 21x3, not confirmed).</summary>
    public int HandleCount { get; init; } = 8;

    /// <summary>Resolution of the CR angles in degrees (galil-dmc.md B.3: 1/65536 or 1/256); 0 keeps them as given.</summary>
    public double AngleQuantumDegrees { get; init; } = 1.0 / 65536;

    /// <summary>Resolution of the CR radius in counts, truncated (galil-dmc.md B.3); 0 keeps it real.</summary>
    public double RadiusQuantum { get; init; } = 1;

    /// <summary>True when the ramp to the speed after "&gt;" begins at the start of its segment and that speed is then held to the end; false when it begins
    /// as late as possible (galil-dmc.md B.4).</summary>
    public bool EarlyRamps { get; init; }

    /// <summary>True when a "&gt;" is ignored that arrives while the "&gt;" of an earlier segment has not been executed (galil-dmc.md B.4).</summary>
    public bool OnePendingExit { get; init; }

    /// <summary>True when the speed after "&lt;" applies to its own segment only, and a segment without it runs at VS; false when it applies until the next
    /// "&lt;" or VS (galil-dmc.md B.1, B.4).</summary>
    public bool OwnEntrySpeed { get; init; }

    /// <summary>Virtual time that one host command takes at speed max (galil-dmc.md A.4).</summary>
    public TimeSpan CommandCost { get; init; } = TimeSpan.FromMilliseconds(1.6);

    /// <summary>Time that the controller takes to decode and execute one command of a host, before its prompt: at every speed, over every link, and in
    /// addition to the time of the link (<see cref="CommandCost"/>, or ten bits a byte on the serial port). By default it is part of the time of the
    /// link.</summary>
    public TimeSpan DecodeTime { get; init; }

    /// <summary>Controller time that one command of a running program takes (galil-dmc.md A.4, I.8).</summary>
    public TimeSpan LineCost { get; init; } = TimeSpan.FromMilliseconds(0.5);

    /// <summary>Separator of two numbers of a message when the second is negative (galil-dmc.md A.3: the pages of the manual differ).</summary>
    public NumberSpacing NumberSpacing { get; init; }

    /// <summary>Lines of program memory (galil-dmc.md 0.3).</summary>
    public int ProgramLines { get; init; } = 1000;

    /// <summary>Number of contour records that can wait while one is executed (galil-dmc.md C.4): 1 as on older controllers, whose programs wait with WC, or
    /// 511 as on newer controllers.</summary>
    public int ContourRecords { get; init; } = 1;

    /// <summary>Reply to ^R^V (galil-dmc.md I.6).</summary>
    public string Model { get; init; } = "DMC2143 Rev 1.0o";

    /// <summary>Reply to _BN: the serial number of the processor board (galil-dmc.md 0.3). By default each simulated controller has a different one.</summary>
    public int SerialNumber { get; init; } = Random.Shared.Next(1, int.MaxValue);

    /// <summary>True when automatic subroutines need a running thread 0 (galil-dmc.md C.3, [U]).</summary>
    public bool HandlersNeedThreadZero { get; init; } = true;

    /// <summary>Time constant of the servo lag between the motors and their commanded positions (galil-dmc.md I.14); zero for a perfect motor.</summary>
    public TimeSpan ServoLag { get; init; }

    /// <summary>Letters of the axes whose encoder polarity is opposite to that of their motor: such a servo runs away until its motor type or its encoder type
    /// is reversed
    /// (galil-dmc.md C, MT and CE).</summary>
    public string ReversedWiring { get; init; } = "";

    /// <summary>Positions of limit switches, home switches and index pulses. An omitted axis has only switches that are set manually, and an index pulse every
    /// 4000 counts.</summary>
    public IReadOnlyList<AxisSwitches> Switches { get; init; } = [];

    /// <summary>Speeds and accelerations that were burned before power up; null for the factory values.</summary>
    public BurnedMotion? Burned { get; init; }

    /// <summary>Destination of program messages after power up: A to H, or S for the serial port (CF, galil-dmc.md A.5).</summary>
    public char MessagePort { get; init; } = 'S';

    /// <summary>Bit 7 of messages after power up: 1 set, 2 not set (CW, galil-dmc.md A.5).</summary>
    public int MessageMarking { get; init; } = 2;

    /// <summary>The address that TH and _IA0 report; the controller listens on loopback in any case.</summary>
    public IPAddress Address { get; init; } = IPAddress.Loopback;

    /// <summary>True when <see cref="SimulatedController.Record"/> stores its rows. When false, its listeners and its file still receive them, and memory does
    /// not grow with machine time.</summary>
    public bool KeepsRecord { get; init; } = true;

    /// <summary>True when samples of constant speed in which no other event can occur are computed in one jump instead of one by one; the result is the same to
    /// the last bit.</summary>
    public bool JumpsSteadyMotion { get; init; } = true;

    /// <summary>The wall clock and its timers.</summary>
    public TimeProvider Time { get; init; } = TimeProvider.System;

    /// <summary>Faults to inject; null for no faults.</summary>
    public FaultPlan? Faults { get; init; }

    /// <summary>True when time is virtual ("max").</summary>
    public bool IsVirtual => double.IsPositiveInfinity(Speed);
}
