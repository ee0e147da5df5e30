using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>Runs a motion program on a controller and leaves the controller as it was found.</summary>
public static class JobRunner
{
    /// <summary>Runs the job to its end, to the operator's stop, to the first refusal or to the loss of the link; it always returns, with what the controller last reported.</summary>
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
    public static async Task<JobResult> GoToAsync(
        MotionProgram program, CountsPoint goal, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(session);
        string off = string.Concat(session.Found.MotorsOff.Where(program.Profile.Axes.Letters.Contains));
        return off.Length > 0
            ? JobResult.NotStarted(program.Strokes.Count, Wording.Get("JobRunner.MotorAxisOffSwitch", string.Join(Wording.Get("Common.And"), off.AsEnumerable())))
            : await RunAsync(program, goal, session, options with { DryRun = true }, progress, stop).ConfigureAwait(false);
    }

    private static async Task<JobResult> RunAsync(
        MotionProgram program, CountsPoint? goTo, ControllerSession session, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(session);
        ArgumentNullException.ThrowIfNull(options);
        if (program.Profile.Axes.Letters.Except(session.Identity.Letters).ToList() is { Count: > 0 } missing)
            return JobResult.NotStarted(program.Strokes.Count, Wording.Get("JobRunner.MachineProfileMovesAxis", string.Join(Wording.Get("Common.And"), missing), session.Identity.Letters));
        JobJournal journal;
        try
        {
            journal = new JobJournal(options.JournalPath);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            return JobResult.NotStarted(program.Strokes.Count, Wording.Get("JobRunner.JournalCannotWrittenName", failure.Message));
        }

        // Replies from memory are immediate: without a thread of its own the whole job would run before this method returns.
        using (journal) return await Task.Run(new Job(program, session, options, progress, journal, stop, goTo).RunAsync, CancellationToken.None).ConfigureAwait(false);
    }
}
