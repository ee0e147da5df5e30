using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>One circuit around a job with the tool off, at the active work origin, on a machine that stays connected.</summary>
internal static class MachineFraming
{
    /// <param name="lease">The lease of the machine, with what is stored of it.</param>
    /// <param name="placed">Called with the place of the drawing's zero when it was found, controller counts.</param>
    /// <exception cref="ControllerException">The link never came up.</exception>
    public static async Task<JobResult> RunAsync(MachineConnection connection, MachineLease lease, MotionProgram frame, string journal, Action<CountsPoint?> placed, IProgress<JobProgress> progress, CancellationToken stop)
    {
        using var clock = connection.CreateClock();
        await using var machine = await clock.HandshakeAsync(connection, trace: null, stop).ConfigureAwait(false);
        var placement = await JobPlacement.FindAsync(machine, lease, frame, dryRun: true, new OriginRequest.ActiveOrigin(), FinishPlace.Stay, null, clock.Time, stop).ConfigureAwait(false);
        if (placement.Found is { Refusal: { } unplaced }) return JobResult.NotStarted(frame.Strokes.Count, unplaced.Message) with { Diagnostics = [unplaced] };
        placed(placement.Found.Frame);
        placement.NoteStart();
        var options = new JobOptions { JournalPath = journal, Address = connection.Description, DrawingName = "CNCFRAME", DryRun = true, Frame = placement.Found.Frame, SoftLimits = placement.KnowsTravel ? TravelLimits.Of(placement.Program.Profile) : [] };
        var result = await machine.RunAsync(placement.Program, options, progress, stop).ConfigureAwait(false);
        return placement.NoteEnd(result) is { } unkept ? result with { Diagnostics = [.. result.Diagnostics, unkept] } : result;
    }
}
