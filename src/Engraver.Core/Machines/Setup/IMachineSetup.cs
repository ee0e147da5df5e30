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
