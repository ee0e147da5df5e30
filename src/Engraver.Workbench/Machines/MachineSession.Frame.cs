using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>The part of the machine session that goes round a job.</summary>
public sealed partial class MachineSession
{
    /// <summary>Goes once round a job with the tool off, at the active work origin, and disarms. It is stopped as a job is; what the last job cut stays
    /// known.</summary>
    /// <param name="frame">Made of the job (<see cref="JobFrame"/>).</param>
    /// <param name="journal">Where what is found in the controller is written down.</param>
    /// <returns>How it ended; the diagnostic says why nobody knows where the job lies.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs already.</exception>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public async Task<JobResult> FrameAsync(MotionProgram frame, string journal, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(frame);
        await FreeAsync().ConfigureAwait(false);
        if (_watched is not { Connection: { } connection, Address: { } address }) throw new InvalidOperationException("No controller is connected.");
        return await _work.RunAsync(stop => FrameWatchedAsync(connection, JobPlan.FitFrameToLink(frame, address), journal, stop), cancellation).ConfigureAwait(false);
    }

    private async Task<JobResult> FrameWatchedAsync(MachineConnection connection, MotionProgram frame, string journal, CancellationToken stop)
    {
        _status.MoveBegins(Wording.Get("MachineSession.Frame"));
        await _watched.GiveWayAsync().ConfigureAwait(false);
        try
        {
            var result = await RoundAsync(connection, Hold!, frame, journal, stop).ConfigureAwait(false);
            if (result.FrameOrigin is not null) _status.MoveEnds(result);
            return result;
        }
        finally
        {
            await _watched.ResumeAsync(connection).ConfigureAwait(false);
        }
    }

    private async Task<JobResult> RoundAsync(MachineConnection connection, MachineHold hold, MotionProgram frame, string journal, CancellationToken stop)
    {
        using var clock = connection.TakeClock();
        await using var machine = await clock.ShakeHandsAsync(connection, trace: null, stop).ConfigureAwait(false);
        var placement = await JobPlacement.FindAsync(machine, hold, frame, dryRun: true, new OriginRequest.Work(), FinishPlace.Stay, clock.Time, stop).ConfigureAwait(false);
        if (placement.Found is { Refusal: { } unplaced }) return JobResult.NotStarted(frame.Strokes.Count, unplaced.Message) with { Diagnostics = [unplaced] };
        _status.Placed(placement.Found.Frame);
        placement.Begin();
        var options = new JobOptions { JournalPath = journal, Address = connection.Description, DrawingName = "CNCFRAME", DryRun = true, Frame = placement.Found.Frame, SoftLimits = placement.KnowsTravel ? TravelLimits.Of(placement.Program.Profile) : [] };
        var result = await machine.RunAsync(placement.Program, options, new JobListener(TellMove), stop).ConfigureAwait(false);
        return placement.End(result) is { } unkept ? result with { Diagnostics = [.. result.Diagnostics, unkept] } : result;
    }
}
