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
    public FaultError? Validate()
    {
        var moments = (AtSeconds is null ? 0 : 1) + (AtSegment is null ? 0 : 1) + (AtByte is null ? 0 : 1);
        if (moments != 1) return new FaultError("kind", FaultErrorReason.Moments);
        if (AtSeconds is not null and not (>= 0.0 and < 1e9)) return new FaultError("atSeconds", FaultErrorReason.BelowZero);
        if (AtSegment < 0) return new FaultError("atSegment", FaultErrorReason.BelowZero);
        if (AtByte < 0) return new FaultError("atByte", FaultErrorReason.BelowZero);
        if (NeedsAxis != (Axis is not null)) return NeedsAxis ? new FaultError("kind", FaultErrorReason.NoAxis) : new FaultError("axis", FaultErrorReason.HasNoAxis);
        if (Axis is not (null or "A" or "B" or "C" or "D")) return new FaultError("axis", FaultErrorReason.OtherAxis);
        if (ForSeconds is not null && !MayEnd) return new FaultError("forSeconds", FaultErrorReason.NeverEnds);
        if (ForSeconds is not null and not (> 0.0 and < 1e9)) return new FaultError("forSeconds", FaultErrorReason.NotAboveZero);
        if (Seconds is not (>= 0.0 and < 1e6)) return new FaultError("seconds", FaultErrorReason.BelowZero);
        return Count < 1 ? new FaultError("count", FaultErrorReason.BelowOne) : null;
    }
}
