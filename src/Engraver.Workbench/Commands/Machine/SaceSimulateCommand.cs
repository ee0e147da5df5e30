using Engraver.Core.Diagnostics;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Trajectories;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>SACESIMULATE: Runs the trajectories on a simulated controller as arcs and lines, and reports the deviation from the curves that they follow; no
/// machine moves.</summary>
internal sealed class SaceSimulateCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACESIMULATE", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var followed = TrajectoryJob.Prepare(context.Drawing, context.Document.Current.Settings, TrajectorySelection.All(context), context.Driver.DefaultStrategy.Style);
        var job = followed.Job;
        FindingMessages.Write(context, job.Drawing.FileName, job.Diagnostics, Severity.Warning);
        if (job.Motion.Program is not { SegmentCount: > 0 } program) throw new CommandException(CommandFailure.Drawing, $"{job.NoProgramReason}.");
        await JobStart.RunAsync(context, job, checks: null, options => context.Machine.Runs.SimulateAsync(job, program, address => options(JobStart.Options(context, job, address, context.Driver.DefaultStrategy, dryRun: false) with { Resume = null }), cancellation), simulated: true).ConfigureAwait(false);
        context.WriteMessage(Wording.Get("Trajectories.Simulated", DisplayPrecision.FormatErrorBound(followed.Bound)), MessageKind.Result);
    }
}
