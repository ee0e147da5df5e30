using System.Diagnostics.CodeAnalysis;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Machines.Setup;

namespace Engraver.Core.Machines;

/// <summary>A connected and identified controller: the interface between the workbench and a family of controllers (ADR 9). Its terms are neutral; the driver
/// decides which commands it sends for them.</summary>
/// <remarks>Disposing leaves the controller as it was found. Stop and abort may be called from any thread, concurrently with all other members.</remarks>
public interface IMachineConnection : IAsyncDisposable
{
    MachineIdentity Identity { get; }

    MachineCapabilities Capabilities { get; }

    /// <summary>The link was lost; another connection is needed.</summary>
    bool IsBroken { get; }

    /// <summary>Reads the present state of an idle machine once.</summary>
    /// <param name="axes">The axes that a job moves.</param>
    /// <exception cref="ControllerException">The link failed, or the controller cannot report its position.</exception>
    ValueTask<MachineReading> ReadStatusAsync(MachineAxes axes, CancellationToken cancellation);

    /// <summary>Reads the position of the machine and the values that show whether the controller still counts from the same zero.</summary>
    /// <param name="axes">The axes that move the drawing's X and Y.</param>
    /// <exception cref="ControllerException">The link failed, or the controller cannot report its position.</exception>
    ValueTask<ControllerPosition> ReadPositionAsync(MachineAxes axes, CancellationToken cancellation);

    /// <summary>Stores a number in the controller that is lost when the controller is switched off or reset.</summary>
    /// <returns>False when the controller does not accept it.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    ValueTask<bool> StoreMarkAsync(int mark, CancellationToken cancellation);

    /// <summary>Switches the tool off and brakes the path and every axis. Returns when the controller has accepted the stop, not when the machine is at
    /// rest.</summary>
    /// <param name="outputs">The outputs to switch off (<see cref="MachineProfile.OffAtStop"/>).</param>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task StopAsync(params IReadOnlyList<OutputSwitch> outputs);

    /// <summary>Halts every motion and program immediately, and switches tool and motors off.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    /// <param name="outputs">The outputs to switch off (<see cref="MachineProfile.OffAtAbort"/>).</param>
    Task AbortAsync(params IReadOnlyList<OutputSwitch> outputs);

    /// <summary>Switches the motors of the axes that a job moves on or off.</summary>
    /// <returns>The refusal; null when it was done.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task<MachineRefusal?> SetMotorsAsync(MachineAxes axes, bool on, CancellationToken cancellation);

    /// <summary>Switches one digital output, numbered from 1.</summary>
    /// <returns>The refusal; null when it was done.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task<MachineRefusal?> SetOutputAsync(int output, bool on, CancellationToken cancellation);

    /// <summary>Sends a line that an operator typed in the controller's own language, and returns the replies.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task<IReadOnlyList<TerminalAnswer>> ExecuteLineAsync(string line, CancellationToken cancellation);

    /// <summary>Measures the link, and lowers the speeds of a program whose segments it cannot carry in time.</summary>
    /// <param name="program">As <see cref="Motion.IMachineDriver.LimitFeedToLink"/> has adapted it to the kind of the link.</param>
    /// <param name="sourceOf">Position of an entity in the drawing's file; null if it is not known.</param>
    /// <returns>The program itself, and no finding, where the link is as fast as planned.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    ValueTask<LinkFeedFit> FitToLinkAsync(MotionProgram program, ExecutionStrategy strategy, Func<int, SourceRef>? sourceOf, CancellationToken cancellation) => new(new LinkFeedFit(program, []));

    /// <summary>Takes text that programs in the controller have printed since the last call.</summary>
    bool TryTakeMessage([NotNullWhen(true)] out string? message);

    /// <summary>Runs a motion program until its end, the operator's stop, the first refusal or the loss of the link, and leaves the controller as it was
    /// found.</summary>
    /// <param name="stop">The operator's stop: the method first waits until the machine has stopped, however long it brakes, then returns.</param>
    Task<JobResult> RunAsync(MotionProgram program, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop);

    /// <summary>Finds where an interrupted job is to continue, from its journal and from what the controller has kept of the job.</summary>
    /// <param name="program">The whole program of the job, as it would be run again.</param>
    /// <param name="journal">Path of the journal.</param>
    /// <returns>The place, or the reason why there is none.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    Task<ResumePosition> FindResumeAsync(MotionProgram program, ExecutionStrategy strategy, string journal, CancellationToken cancellation);

    /// <summary>Moves the machine without cutting, tool off, at rapid speed, under the same watchdog and stop as a job.</summary>
    /// <param name="program">Has no strokes; supplies the machine, and its position in the frame in which progress is reported.</param>
    /// <param name="goal">Target in the controller's own counts.</param>
    /// <param name="withHeight">The height is part of the target; otherwise it does not change.</param>
    Task<JobResult> GoToAsync(MotionProgram program, CountsPoint goal, bool withHeight, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop);

    /// <summary>Moves the machine while a key is held, tool off, under a watchdog in the controller that brakes it 0.25 s after the last heartbeat from this
    /// computer.</summary>
    /// <param name="program">As for <see cref="GoToAsync"/>.</param>
    /// <param name="control">Speed of each axis; releasing it ends the jog, which is then complete.</param>
    /// <param name="stop">The operator's stop.</param>
    Task<JobResult> JogAsync(MotionProgram program, JogControl control, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop);

    /// <summary>Keeps the controller ready for jogs, each as in <see cref="JogAsync"/>, until <paramref name="standby"/> is left, no jog was started for a
    /// while, or a jog ended other than by its release.</summary>
    /// <param name="program">As for <see cref="GoToAsync"/>.</param>
    /// <param name="stop">The operator's stop.</param>
    /// <returns>How it ended, after the controller has been left as it was found.</returns>
    Task<JobResult> StandByAsync(MotionProgram program, JogStandby standby, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop);

    /// <summary>Homes the axes whose homing the profile configures, one after the other, tool off, under the watchdog and the stop of a job. Afterwards the
    /// controller counts from the profile's zero.</summary>
    /// <param name="program">As for <see cref="GoToAsync"/>.</param>
    Task<HomingResult> HomeAsync(MotionProgram program, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop);

    /// <summary>Reads and changes the controller's settings for motors, encoders and switches; null where it is not offered.</summary>
    IMachineSetup? Setup => null;

    /// <summary>Planned seconds of a program over this link.</summary>
    double PlannedSeconds(MotionProgram program, ExecutionStrategy strategy);
}
