using Engraver.Galil.Jobs;

namespace Engraver.Workbench.Commands;

/// <summary>CNCSIM: Runs the drawing on a simulated controller and says how well it was cut; no machine moves.</summary>
internal sealed class CncSimCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCSIM", CommandGroup.Machine, "Runs the drawing on a simulated controller and says how well it was cut; no machine moves.");

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var job = await JobStart.PrepareAsync(context, JobMode.Stream).ConfigureAwait(false);
        var report = await context.Machine.SimulateAsync(job, job.Motion.Program!, address => JobStart.Options(context, job, address, JobMode.Stream, dryRun: false) with { Starts = null }, cancellation).ConfigureAwait(false);
        JobStart.Conclude(context, job, report);
    }
}
