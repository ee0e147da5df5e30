using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>Runs a motion program on a controller and leaves the controller as it was found.</summary>
public static class JobRunner
{
    /// <summary>Runs the job to its end, to the operator's stop, to the first refusal or to the loss of the link; it always returns, with what the
    /// controller last reported.</summary>
    /// <param name="session">Open, and the machine at rest. It stays open.</param>
    /// <param name="progress">Receives the progress, 20 times a second of controller time; may be null.</param>
    /// <param name="stop">The operator's stop: the machine is stopped first, however long it brakes, then this returns.</param>
    public static async Task<JobResult> RunAsync(
        MotionProgram program, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop) =>
        await RunAsync(program, null, session, options, progress, stop).ConfigureAwait(false);

    /// <summary>Moves the machine without cutting: tool off, at rapid speed, each axis at its own, under the same watchdog and stop as a job.</summary>
    /// <param name="program">Has no strokes; gives the machine, and its position in the frame in which progress is reported.</param>
    /// <param name="goal">Target in the controller's own counts.</param>
    /// <returns>As for a job; refused when a motor is off, because a move switches nothing on.</returns>
    public static Task<JobResult> GoToAsync(
        MotionProgram program, CountsPoint goal, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop, bool withHeight = false) =>
        ByHandAsync(program, new HandOperation(null, machine => new HandMove(machine, goal, withHeight)), session, options, progress, stop);

    /// <summary>Moves the machine as long as a key is held (<see cref="JogMove"/>).</summary>
    /// <returns>As for <see cref="GoToAsync"/>; complete when the key was released.</returns>
    public static async Task<JobResult> JogAsync(MotionProgram program, JogControl control, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        ArgumentNullException.ThrowIfNull(control);
        ArgumentNullException.ThrowIfNull(options);
        var either = new CancellationTokenSource(); // not disposed: the key may be released at any time, and it has no timer
        await using var stopped = stop.UnsafeRegister(source => ((CancellationTokenSource)source!).Cancel(), either).ConfigureAwait(false);
        _ = control.Released.ContinueWith(_ => either.Cancel(), CancellationToken.None, TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default);
        var result = await ByHandAsync(program, new HandOperation(null, machine => new JogMove(machine, control, options.SoftLimits)), session, options, progress, either.Token).ConfigureAwait(false);
        return result.Outcome == JobOutcome.Stopped && !stop.IsCancellationRequested ? result with { Outcome = JobOutcome.Complete, Message = Wording.Get("JogMove.AtRest") } : result;
    }

    /// <summary>Keeps the controller ready for jogs (<see cref="JogStandbyMove"/>).</summary>
    /// <returns>As for <see cref="GoToAsync"/>.</returns>
    public static Task<JobResult> StandByAsync(MotionProgram program, JogStandby standby, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        ArgumentNullException.ThrowIfNull(standby);
        ArgumentNullException.ThrowIfNull(options);
        return ByHandAsync(program, new HandOperation(null, machine => new JogStandbyMove(machine, standby, options.SoftLimits)), session, options, progress, stop);
    }

    /// <summary>Homes the axes for which the profile configures it (<see cref="HomingMove"/>). The controller's own software limits are not in force
    /// meanwhile: they belong to the previous zero.</summary>
    /// <returns>As for <see cref="GoToAsync"/>.</returns>
    public static async Task<HomingResult> HomeAsync(MotionProgram program, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(options);
        HomingMove? homing = null;
        var hand = new HandOperation(ResidentProgram.ForHoming(program.Profile), machine => homing = new HomingMove(machine));
        var free = options with { SoftLimits = [.. program.Profile.Axes.All.Select(axis => SoftLimit.None(axis.Letter))] };
        var result = await ByHandAsync(program, hand, session, free, progress, stop).ConfigureAwait(false);
        return result.Outcome == JobOutcome.Complete ? new HomingResult(result with { Message = Wording.Get("HomingMove.Homed") }, homing!.Shift) : new HomingResult(result, null);
    }

    /// <summary>Switches the profile's tool output on for its settle time and off again, under the watchdog: when this computer fails meanwhile the
    /// controller switches it off.</summary>
    /// <returns>As for <see cref="GoToAsync"/>.</returns>
    public static Task<JobResult> PulseAsync(MotionProgram program, ControllerSession session, JobOptions options, CancellationToken stop) =>
        ByHandAsync(program, new HandOperation(null, machine => new OutputPulse(machine)) { IsDry = false }, session, options, null, stop);

    private static async Task<JobResult> ByHandAsync(MotionProgram program, HandOperation hand, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(session);
        string off = string.Concat(session.Found.MotorsOff.Where(program.Profile.Axes.Letters.Contains));
        return off.Length > 0
            ? JobResult.NotStarted(program.Strokes.Count, Wording.Get("JobRunner.MotorsOff", string.Join(", ", program.Profile.Axes.NamesOf(off).AsEnumerable())))
            : await RunAsync(program, hand, session, options with { DryRun = hand.IsDry }, progress, stop).ConfigureAwait(false);
    }

    private static async Task<JobResult> RunAsync(
        MotionProgram program, HandOperation? hand, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(session);
        ArgumentNullException.ThrowIfNull(options);
        if (program.Profile.Axes.Letters.Except(session.Identity.Letters).ToList() is { Count: > 0 } missing)
            return JobResult.NotStarted(program.Strokes.Count, Wording.Get("JobRunner.NoSuchAxis", string.Join(", ", missing), session.Identity.Letters));
        JobJournal journal;
        try
        {
            journal = new JobJournal(options.JournalPath);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            return JobResult.NotStarted(program.Strokes.Count, Wording.Get("JobRunner.JournalNotWritable", SystemErrorText.FromException(failure)));
        }

        // Replies from memory are immediate: without its own thread the whole job would run before this method returns.
        using var order = new StopOrder(stop);
        using (journal) return await Task.Run(new Job(program, session, options, progress, journal, order, hand).RunAsync, CancellationToken.None).ConfigureAwait(false);
    }
}
