namespace Engraver.Core.Machines.Setup;

/// <summary>Reads and sets the controller's settings for the motors, encoders and switches that are wired to it. Every setting lasts until power-off, unless it
/// is burned.</summary>
public interface IMachineSetup
{
    /// <param name="letters">The controller's letters of the axes.</param>
    /// <exception cref="ControllerException">The link failed.</exception>
    ValueTask<SetupFacts> ReadAsync(string letters, CancellationToken cancellation);

    /// <summary>Sets one value and reads it back; when the controller then has another value, the previous one is set again.</summary>
    /// <returns>Why the controller does not have the value; null when it has.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task<string?> SetAsync(SetupValue value, CancellationToken cancellation);

    /// <summary>Switches one motor. A motor that is switched on is monitored for half a second of controller time: when it runs away it is switched off
    /// immediately.</summary>
    /// <returns>Why the motor is not as requested, and what to do; null when it is.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task<string?> SwitchMotorAsync(char axis, bool on, CancellationToken cancellation);

    /// <summary>Switches the tool's output of the profile on for its settle time and off again, at standstill, under the watchdog and the stop of a
    /// job.</summary>
    /// <param name="program">Has no strokes; supplies the machine.</param>
    /// <returns>As for a move by hand; refused while a motor is off.</returns>
    Task<JobResult> PulseAsync(MotionProgram program, JobOptions options, CancellationToken stop);

    /// <summary>Writes the present settings of the controller to the memory that survives power-off.</summary>
    /// <returns>The refusal; null when it was done.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task<string?> BurnAsync(CancellationToken cancellation);
}

/// <summary>The controller's settings of its wiring. Null for a value that it does not report, or that has no name here.</summary>
/// <param name="LimitSense">Level at which a limit switch counts as hit, one for all axes.</param>
/// <param name="HomeSense">How the home inputs are read, one for all axes.</param>
/// <param name="Axes">In the requested order.</param>
public sealed record SetupFacts(SwitchSense? LimitSense, SwitchSense? HomeSense, IReadOnlyList<AxisFacts> Axes)
{
    /// <exception cref="InvalidOperationException">That axis was not requested.</exception>
    public AxisFacts this[char letter] => Axes.First(axis => axis.Letter == letter);
}

/// <summary>The controller's settings and state of one axis.</summary>
/// <param name="Letter">The controller's letter of the axis.</param>
/// <param name="Motor">The signal that it sends to the drive.</param>
/// <param name="Encoder">How it reads the encoder.</param>
/// <param name="ErrorLimit">Following error beyond which the controller reports an error, counts; 0 or less: never.</param>
/// <param name="OffOnError">The controller switches the motor off beyond that limit.</param>
/// <param name="Position">Commanded position, counts.</param>
/// <param name="Error">Following error, counts.</param>
public sealed record AxisFacts(char Letter, MotorType? Motor, EncoderType? Encoder, int? ErrorLimit, bool? OffOnError, int Position, int Error)
{
    public bool IsMotorOff { get; init; }

    /// <summary>The limit switch in the direction of increasing counts is active, by the present sense.</summary>
    public bool? ForwardHit { get; init; }

    /// <summary>The limit switch in the direction of decreasing counts is active, by the present sense.</summary>
    public bool? ReverseHit { get; init; }

    /// <summary>The home input, by the present sense.</summary>
    public bool? Home { get; init; }
}
