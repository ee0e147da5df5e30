using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCSTATUS: Says what is connected and what the machine is doing.</summary>
internal sealed class CncStatusCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCSTATUS", CommandGroup.Machine, "Says what is connected and what the machine is doing.") { Transparent = true, HeardDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var machine = context.Machine;
        context.SayResult(output =>
        {
            output.WriteLine(machine.Description is { } description ? $"{(machine.IsSimulation ? "SIMULATION" : "CONNECTED")}: {machine.Identity?.Model} at {description}" : "OFFLINE");
            if (machine.Description is not null) output.WriteLine(StateText(machine.Status));
            if (machine.IsRunning) output.WriteLine("RUNNING");
            if (machine.Progress is { } at) output.WriteLine(FormattableString.Invariant($"stroke {at.Stroke + 1}, {at.SegmentsExecuted} of {at.SegmentCount} segments, tool {(at.ToolOn ? "on" : "off")}, {at.Seconds:0.0} s"));
            if (!machine.IsRunning && machine.LastRun is { } last) output.WriteLine($"last job: {OutcomeText.Word(last.Result.Outcome)}");
        });
        return Task.CompletedTask;
    }

    private static string StateText(MachineStatus status)
    {
        var place = status.MachinePosition is { } at ? $", machine {PointPrompt.Show(at)} mm" : "";
        var work = status.WorkPosition is { } here ? $", work {PointPrompt.Show(here)} mm" : "";
        return $"state {status.State}{(status.Reason.Length > 0 ? $" ({status.Reason})" : "")}{place}{work}{(status.LastRefusal is { } refused ? $", last refusal: {refused}" : "")}";
    }
}
