using Engraver.Simulator.Motion;

namespace Engraver.Simulator;

/// <summary>One fault that occurs once, at its trigger: a time, a segment or a byte.</summary>
public sealed record ScheduledFault
{
    public required FaultKind Kind { get; init; }

    /// <summary>Trigger: controller time since power up, seconds.</summary>
    public double? AtSeconds { get; init; }

    /// <summary>Trigger: number of executed vector segments, over all sequences.</summary>
    public long? AtSegment { get; init; }

    /// <summary>Trigger: number of received bytes, over all links.</summary>
    public long? AtByte { get; init; }

    /// <summary>Controller time after which a switch, an input or a shaft is released, seconds; null: never. Only for <see cref="FaultKind.LimitSwitch"/>,
    /// <see cref="FaultKind.AbortInput"/> and <see cref="FaultKind.Jam"/>.</summary>
    public double? ForSeconds { get; init; }

    /// <summary>A to D: the axis of a limit switch, a motor or a jam.</summary>
    public string? Axis { get; init; }

    /// <summary>The forward limit switch instead of the reverse one.</summary>
    public bool Forward { get; init; }

    /// <summary>Delay of an answer, seconds (<see cref="FaultKind.Delay"/>): controller time at speed max, wall time otherwise.</summary>
    public double Seconds { get; init; } = 0.5;

    /// <summary>Number of delayed answers, lost commands or answers, or garbage bytes before the next answer.</summary>
    public int Count { get; init; } = 1;

    internal int AxisIndex => AxisSelection.IndexOf(Axis![0]);

    private bool NeedsAxis => Kind is FaultKind.LimitSwitch or FaultKind.MotorOff or FaultKind.Jam;

    private bool MayEnd => Kind is FaultKind.LimitSwitch or FaultKind.AbortInput or FaultKind.Jam;

    /// <summary>The reason why the fault cannot occur, with the invalid field; null for a valid fault.</summary>
    public FaultFlaw? Flaw()
    {
        var moments = (AtSeconds is null ? 0 : 1) + (AtSegment is null ? 0 : 1) + (AtByte is null ? 0 : 1);
        if (moments != 1) return new FaultFlaw("kind", FlawReason.Moments);
        if (AtSeconds is not null and not (>= 0.0 and < 1e9)) return new FaultFlaw("atSeconds", FlawReason.BelowZero);
        if (AtSegment < 0) return new FaultFlaw("atSegment", FlawReason.BelowZero);
        if (AtByte < 0) return new FaultFlaw("atByte", FlawReason.BelowZero);
        if (NeedsAxis != (Axis is not null)) return NeedsAxis ? new FaultFlaw("kind", FlawReason.NoAxis) : new FaultFlaw("axis", FlawReason.HasNoAxis);
        if (Axis is not (null or "A" or "B" or "C" or "D")) return new FaultFlaw("axis", FlawReason.OtherAxis);
        if (ForSeconds is not null && !MayEnd) return new FaultFlaw("forSeconds", FlawReason.NeverEnds);
        if (ForSeconds is not null and not (> 0.0 and < 1e9)) return new FaultFlaw("forSeconds", FlawReason.NotAboveZero);
        if (Seconds is not (>= 0.0 and < 1e6)) return new FaultFlaw("seconds", FlawReason.BelowZero);
        return Count < 1 ? new FaultFlaw("count", FlawReason.BelowOne) : null;
    }
}

/// <summary>The error in a fault.</summary>
/// <param name="Field">Name of the field in a faults file.</param>
public readonly record struct FaultFlaw(string Field, FlawReason Reason);

/// <summary>The reason why a fault cannot occur.</summary>
public enum FlawReason
{
    /// <summary>The fault has no trigger, or more than one.</summary>
    Moments,

    /// <summary>A number is below 0, or too large.</summary>
    BelowZero,

    /// <summary>A time is not above 0, or too large.</summary>
    NotAboveZero,

    /// <summary>A number is below 1.</summary>
    BelowOne,

    /// <summary>This kind of fault needs an axis.</summary>
    NoAxis,

    /// <summary>This kind of fault takes no axis.</summary>
    HasNoAxis,

    /// <summary>The axis is not A, B, C or D.</summary>
    OtherAxis,

    /// <summary>This kind of fault has no duration.</summary>
    NeverEnds,
}

/// <summary>The kinds of scheduled faults.</summary>
public enum FaultKind
{
    /// <summary>Answers are delayed.</summary>
    Delay,

    /// <summary>A command is lost: it is neither executed nor answered.</summary>
    DropCommand,

    /// <summary>A command is executed, but its answer is lost.</summary>
    DropReply,

    /// <summary>Garbage bytes precede the next answer.</summary>
    Garbage,

    /// <summary>Every link is cut, as by a disconnected cable; motion and programs continue.</summary>
    Reset,

    /// <summary>A limit switch is hit.</summary>
    LimitSwitch,

    /// <summary>The abort input is closed.</summary>
    AbortInput,

    /// <summary>A motor is switched off, as by off-on-error: the motion that drives its axis stops without a ramp.</summary>
    MotorOff,

    /// <summary>A shaft is blocked: its motor does not move, and the position error grows.</summary>
    Jam,

    /// <summary>The controller is switched off and on again: links, variables, programs and positions are lost, the burned state is restored (galil-dmc.md
    /// A.6).</summary>
    PowerCycle,
}
