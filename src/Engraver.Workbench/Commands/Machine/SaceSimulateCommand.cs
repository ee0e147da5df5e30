using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Trajectories;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>SACESIMULATE: Runs the trajectories on a simulated controller as arcs and lines, and says how far it was from what they follow; no machine
/// moves.</summary>
internal sealed class SaceSimulateCommand : ICommand
{
    public CommandInfo Info { get; } = new("SACESIMULATE", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var followed = TrajectoryJob.Prepare(context.Drawing, context.Document.Current.Settings, TrajectoryPick.All(context), MotionStyle.Continuous);
        var job = followed.Job;
        FindingMessages.Say(context, job.Drawing.FileName, job.Diagnostics, Severity.Warning);
        if (job.Motion.Program is not { SegmentCount: > 0 } program) throw new CommandException(CommandFailure.Drawing, $"{job.WithoutProgram}.");
        await JobStart.RunAsync(context, job, checks: null, options => context.Machine.Runs.SimulateAsync(job, program, address => options(JobStart.Options(context, job, address, JobMode.Stream, dryRun: false) with { Resume = null }), cancellation), simulated: true).ConfigureAwait(false);
        context.Say(Wording.Get("Trajectories.Simulated", Figures.Bound(followed.Bound)), MessageKind.Result);
    }
}
