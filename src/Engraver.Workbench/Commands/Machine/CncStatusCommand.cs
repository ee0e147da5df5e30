using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCSTATUS: Says what is connected and what the machine is doing.</summary>
internal sealed class CncStatusCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCSTATUS", CommandGroup.Machine) { Transparent = true, HeardDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var machine = context.Machine;
        context.SayResult(output =>
        {
            output.WriteLine(machine.Description is { } description ? Wording.Get("CncStatus.At", machine.IsSimulation ? Wording.Get("CncStatus.Simulation") : Wording.Get("CncStatus.Connected"), machine.Identity?.Model, description) : Wording.Get("CncStatus.Offline"));
            if (machine.Description is not null) output.WriteLine(StateText(machine.Status));
            if (machine.IsRunning) output.WriteLine(Wording.Get("CncStatus.Running"));
            if (machine.Progress is { } at) output.WriteLine(Wording.Get("CncStatus.StrokeSegmentsTool", at.Stroke + 1, at.SegmentsExecuted, at.SegmentCount, at.ToolOn ? Wording.Get("Common.On") : Wording.Get("Common.Off"), at.Seconds));
            if (!machine.IsRunning && machine.LastRun is { } last) output.WriteLine(Wording.Get("CncStatus.LastJob", OutcomeText.Word(last.Result.Outcome)));
        });
        return Task.CompletedTask;
    }

    private static string StateText(MachineStatus status)
    {
        var place = status.MachinePosition is { } at ? Wording.Get("CncStatus.MachineMm", PointPrompt.Show(at)) : "";
        var work = status.WorkPosition is { } here ? Wording.Get("CncStatus.WorkMm", PointPrompt.Show(here)) : "";
        return Wording.Get("CncStatus.State", status.State, status.Reason.Length > 0 ? $" ({status.Reason})" : "", place, work, status.LastRefusal is { } refused ? Wording.Get("CncStatus.LastRefusal", refused) : "");
    }
}
