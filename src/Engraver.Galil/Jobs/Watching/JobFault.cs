using Engraver.Core.Machines;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Composes the sentence for a fault that a poll showed: where it was, what was wrong, what to check. The stop follows.</summary>
internal sealed class JobFault(JobMachine machine, MotionProgram program, JobLedger ledger)
{
    private const string NobodyElse = "nobody else may use the controller while a job runs.";

    /// <summary>No progress. A damaged command has the same effect as somebody who holds the motion: the job waits for something that does not come.</summary>
    public async ValueTask<JobStep> StalledAsync()
    {
        var ratio = await machine.AskAtRestAsync("_VRS").ConfigureAwait(false);
        var why = ratio is 0.0
            ? "The feed override VR is 0, set by somebody else; " + NobodyElse
            : "A command may have arrived as another one, or somebody else holds the motion; look at the cable and at other programs that use the controller.";
        return JobStep.Broken(Text($"Nothing has moved or been counted for {machine.StandstillSeconds:0.0} s {Place}, though the job is not done: the tool was switched off and the machine stopped. {why}"));
    }

    /// <summary>The watchdog in the controller saw the tool on at standstill before this program did.</summary>
    public JobStep ToolForgotten() => JobStep.Broken(
        Text($"The tool was on while nothing moved {Place}; the watchdog in the controller has switched it off and stopped the machine. Look for another program that uses the controller, and at the cable."));

    public JobStep ToolSwitched()
    {
        var isOn = machine.Tool.IsOutputOn(machine.State);
        return JobStep.Broken(Text($"Output {machine.Profile.ToolOutput} (the tool) was found {(isOn ? "on where it has to be off" : "off while cutting")} {Place}: somebody else switched it, or the command for it arrived as another one. The machine was stopped with the tool off; {NobodyElse}"));
    }

    /// <summary>The watchdog no longer runs: the job could go on, but nothing would stop it if this computer died.</summary>
    public JobStep Unwatched() => JobStep.Broken(
        Text($"The watchdog in the controller that stops the machine when this computer dies was halted by somebody else ({Place}); the machine was stopped. {char.ToUpperInvariant(NobodyElse[0])}{NobodyElse[1..]}"));

    private string Place
    {
        get
        {
            var at = machine.State.Position;
            return program.SegmentBehind(ledger.Executed) is var (_, segment, stroke)
                ? Text($"at {at.X},{at.Y}, stroke {stroke.Index + 1}, drawing entity {segment.EntityIndex}")
                : Text($"at {at.X},{at.Y}");
        }
    }
}
