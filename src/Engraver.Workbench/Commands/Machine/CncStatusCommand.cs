using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCSTATUS: Shows the connection, the machine's state and the start checks; the controller is polled first.</summary>
internal sealed class CncStatusCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCSTATUS", CommandGroup.Machine) { IsTransparent = true, IsAllowedDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var machine = context.Machine;
        var job = context.Derivation is { IsCurrent: true, Current.Job: { } derived } ? derived : null;
        var placement = machine is { Connection.Description: not null, IsRunning: false } ? await machine.Origins.AskAsync(job?.Motion.Program, dryRun: machine.Arming.Armed is { DryRun: true }, cancellation).ConfigureAwait(false) : null;
        context.WriteResult(output =>
        {
            output.WriteLine(machine.Connection.Description is { } description ? Wording.Get("CncStatus.At", machine.Connection.IsSimulation ? Wording.Get("CncStatus.Simulation") : Wording.Get("CncStatus.Connected"), machine.Connection.Identity?.Model, description) : Wording.Get("CncStatus.Offline"));
            if (machine.Connection.Description is not null) output.WriteLine(StateText(machine.Status));
            if (machine.Status is { FeedRatio: var asked, FeedInForce: var feed } && feed < asked) output.WriteLine(Wording.Get("CncStatus.FeedLimited", asked * 100.0, feed * 100.0));
            if (machine.Status.Progress is { } at) output.WriteLine(Wording.Get("CncStatus.Progress", at.Stroke + 1, at.SegmentsDone, at.SegmentCount, at.ToolOn ? Wording.Get("Common.On") : Wording.Get("Common.Off"), at.Seconds));
            if (!machine.IsRunning && machine.Runs.LastRun is { } last) output.WriteLine(Wording.Get("CncStatus.LastJob", OutcomeText.DisplayText(last.Result.Outcome)));
        });
        if (machine.Connection.Description is null || machine.IsRunning) return;
        var now = context.Time.GetUtcNow();
        var checklist = job is null ? ArmingChecklist.ForMachine(machine.Status, now) : ArmingChecklist.Create(job, machine.Status, errorsAccepted: false, placement, now, context.Certificates.StatusOf(job)?.Check);
        foreach (var check in checklist.Checks) ArmingCheckText.Write(context, check);
    }

    private static string StateText(MachineStatus status)
    {
        var parts = new List<string> { status.Reason.Length > 0 ? Wording.Get("CncStatus.StateWithReason", status.State.DisplayText(), status.Reason) : Wording.Get("CncStatus.State", status.State.DisplayText()) };
        if (status.MachinePosition is { } at) parts.Add(Wording.Get("CncStatus.MachinePosition", PositionText.Format(at, status.MachineHeight)));
        if (status.WorkPosition is { } here) parts.Add(Wording.Get("CncStatus.WorkPosition", PositionText.Format(here, status.WorkHeight)));
        if (status.LastRefusal is { } refused) parts.Add(Wording.Get("CncStatus.LastRefusal", refused));
        return string.Join(", ", parts);
    }
}
