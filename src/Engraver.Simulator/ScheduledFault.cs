using System.Text.Json;
using Engraver.Simulator.Motion;

namespace Engraver.Simulator;

/// <summary>One thing that goes wrong once, at the first moment given: a time, a segment or a byte.</summary>
public sealed record ScheduledFault
{
    public required FaultKind Kind { get; init; }

    /// <summary>Controller time since power up, seconds.</summary>
    public double? AtSeconds { get; init; }

    /// <summary>When so many vector segments have been executed, over all sequences.</summary>
    public long? AtSegment { get; init; }

    /// <summary>When so many bytes have arrived, over all links.</summary>
    public long? AtByte { get; init; }

    /// <summary>Controller seconds after which a switch, an input or a shaft is free again; null: never. Only for <see cref="FaultKind.LimitSwitch"/>, <see cref="FaultKind.AbortInput"/> and <see cref="FaultKind.Jam"/>.</summary>
    public double? ForSeconds { get; init; }

    /// <summary>A to D: the axis of a limit switch, a motor or a jam.</summary>
    public string? Axis { get; init; }

    /// <summary>The forward limit switch instead of the reverse one.</summary>
    public bool Forward { get; init; }

    /// <summary>How late an answer comes, seconds (<see cref="FaultKind.Delay"/>): controller time at speed max, wall time otherwise.</summary>
    public double Seconds { get; init; } = 0.5;

    /// <summary>How many answers are late, commands or answers are lost, or bytes of garbage come before the next answer.</summary>
    public int Count { get; init; } = 1;

    internal int AxisIndex => AxisSelection.IndexOf(Axis![0]);

    private bool NeedsAxis => Kind is FaultKind.LimitSwitch or FaultKind.MotorOff or FaultKind.Jam;

    private bool MayEnd => Kind is FaultKind.LimitSwitch or FaultKind.AbortInput or FaultKind.Jam;

    /// <exception cref="JsonException">The fault has no moment or more than one, or a value that its kind does not have.</exception>
    internal void Check()
    {
        var moments = (AtSeconds is null ? 0 : 1) + (AtSegment is null ? 0 : 1) + (AtByte is null ? 0 : 1);
        if (moments != 1) throw new JsonException($"A fault of kind {Kind} needs exactly one of atSeconds, atSegment and atByte.");
        if (AtSeconds is not null and not (>= 0.0 and < 1e9) || AtSegment < 0 || AtByte < 0) throw new JsonException($"The moment of a fault of kind {Kind} lies before the beginning, or is no number.");
        if (NeedsAxis != (Axis is not null)) throw new JsonException(NeedsAxis ? $"A fault of kind {Kind} needs an axis." : $"A fault of kind {Kind} has no axis.");
        if (Axis is not (null or "A" or "B" or "C" or "D")) throw new JsonException($"'{Axis}' is none of the axes A to D.");
        if (ForSeconds is not null && (!MayEnd || ForSeconds is not (> 0.0 and < 1e9))) throw new JsonException($"forSeconds of a fault of kind {Kind} is not allowed or not above 0.");
        if (Seconds is not (>= 0.0 and < 1e6) || Count < 1) throw new JsonException($"seconds of a fault of kind {Kind} is below 0, or count below 1.");
    }
}

/// <summary>What can go wrong at a moment.</summary>
public enum FaultKind
{
    /// <summary>Answers come late.</summary>
    Delay,

    /// <summary>A command arrives nowhere: it is neither executed nor answered.</summary>
    DropCommand,

    /// <summary>A command is executed, and its answer is lost.</summary>
    DropReply,

    /// <summary>Bytes that nobody sent come before the next answer.</summary>
    Garbage,

    /// <summary>Every link is cut, as by a pulled cable; motion and programs go on.</summary>
    Reset,

    /// <summary>A limit switch is hit.</summary>
    LimitSwitch,

    /// <summary>The abort input is closed.</summary>
    AbortInput,

    /// <summary>A motor is switched off, as by off-on-error: what moves its axis stops without a ramp.</summary>
    MotorOff,

    /// <summary>A shaft is blocked: its motor does not move, and the position error grows.</summary>
    Jam,

    /// <summary>The controller is switched off and on again: links, variables, programs and positions are lost, what was burned comes back (galil-dmc.md A.6).</summary>
    PowerCycle,
}
