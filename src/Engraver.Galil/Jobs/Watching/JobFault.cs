using Engraver.Core.Machines;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Composes the sentence for a fault that a poll showed: where it was, what was wrong, what to check. The stop follows.</summary>
internal sealed class JobFault(JobMachine machine, MotionProgram program, JobLedger ledger)
{
    private static string NobodyElse => Wording.Get("JobFault.NobodyElse");

    /// <summary>No progress. A damaged command has the same effect as somebody who holds the motion: the job waits for something that does not come.</summary>
    public async ValueTask<JobStep> StalledAsync()
    {
        var ratio = await machine.AskAtRestAsync("_VRS").ConfigureAwait(false);
        var why = ratio is 0.0
            ? Wording.Get("JobFault.FeedOverrideVrSet", NobodyElse)
            : Wording.Get("JobFault.CommandMayHaveArrived");
        return JobStep.Broken(Wording.Get("JobFault.NothingHasMovedOr", machine.StandstillSeconds, Place, why));
    }

    /// <summary>The watchdog in the controller saw the tool on at standstill before this program did.</summary>
    public JobStep ToolForgotten() => JobStep.Broken(
        Wording.Get("JobFault.ToolOnWhileNothing", Place));

    public JobStep ToolSwitched()
    {
        var isOn = machine.Tool.IsOutputOn(machine.State);
        return JobStep.Broken(Wording.Get("JobFault.OutputToolFoundSomebody", machine.Profile.ToolOutput, isOn ? Wording.Get("JobFault.OnWhereHasOff") : Wording.Get("JobFault.OffWhileCutting"), Place, NobodyElse));
    }

    /// <summary>The watchdog no longer runs: the job could go on, but nothing would stop it if this computer died.</summary>
    public JobStep Unwatched() => JobStep.Broken(
        Wording.Get("JobFault.WatchdogControllerStopsMachine", Place));

    private string Place
    {
        get
        {
            var at = machine.State.Position;
            return program.SegmentBehind(ledger.Executed) is var (_, segment, stroke)
                ? Wording.Get("JobFault.StrokeDrawingEntity", at.X, at.Y, stroke.Index + 1, segment.EntityIndex)
                : Wording.Get("Common.At", at.X, at.Y);
        }
    }
}
