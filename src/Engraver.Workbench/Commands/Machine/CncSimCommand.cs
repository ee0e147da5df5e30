namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCSIM: Runs the drawing on a simulated controller and reports how well it was cut; no machine moves.</summary>
internal sealed class CncSimCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCSIM", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var strategy = context.Driver.DefaultStrategy;
        var job = await JobStart.PrepareAsync(context, strategy).ConfigureAwait(false);
        await JobStart.RunAsync(context, job, checks: null, options => context.Machine.Runs.SimulateAsync(job, job.Motion.Program!, address => options(JobStart.Options(context, job, address, strategy, dryRun: false) with { Resume = null }), cancellation), simulated: true).ConfigureAwait(false);
    }
}
