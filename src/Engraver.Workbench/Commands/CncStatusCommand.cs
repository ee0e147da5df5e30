using Engraver.Workbench.Reports;

namespace Engraver.Workbench.Commands;

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
            if (machine.IsRunning) output.WriteLine("RUNNING");
            if (machine.Progress is { } at) output.WriteLine(FormattableString.Invariant($"stroke {at.Stroke + 1}, {at.SegmentsExecuted} of {at.SegmentCount} segments, tool {(at.ToolOn ? "on" : "off")}, {at.Seconds:0.0} s"));
            if (!machine.IsRunning && machine.LastRun is { } last) output.WriteLine($"last job: {RunText.Word(last.Result.Outcome)}");
        });
        return Task.CompletedTask;
    }
}
