using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCRUN: Runs the armed job (CNCARM) on the connected controller, in a script too; on a simulated one it also runs unarmed and asks first, the
/// drawing or its trajectories.</summary>
internal sealed class CncRunCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_answers = Keyword.List(["Yes", "No", "Dryrun", "Trajectories", .. Enum.GetNames<JobMode>()]);

    public CommandInfo Info { get; } = new("CNCRUN", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is not { } machine) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        _ = context.Drawing;
        if (context.StartIsForHands) throw new CommandException(CommandFailure.Usage, Wording.Get("CncRun.ScriptCannotStart"));
        if (context.Machine.Arming.Armed is { } armed)
        {
            await RunAsync(context, armed.Job, armed.Mode, armed.DryRun, cancellation).ConfigureAwait(false);
            return;
        }

        if (context.RunNeedsArming) throw new CommandException(CommandFailure.Usage, Wording.Get("CncRun.NotArmed", machine));
        var (mode, dryRun, runsTrajectories) = (context.Machine.Runs.Part?.Mode ?? JobMode.Stream, false, false);
        while (true)
        {
            var job = await JobStart.PrepareAsync(context, mode, runsTrajectories).ConfigureAwait(false);
            JobStart.SayPart(context, job, mode);
            var answer = await context.ChoiceAsync(Wording.Get(dryRun ? "CncRun.StartDryRun" : "CncRun.StartCutting", machine, mode), s_answers, "No").ConfigureAwait(false);
            if (answer == "No") return;
            if (answer == "Dryrun") dryRun = true;
            else if (answer == "Trajectories") runsTrajectories = !runsTrajectories;
            else if (Enum.TryParse<JobMode>(answer, out var chosen)) mode = chosen;
            else
            {
                await RunAsync(context, job, mode, dryRun, cancellation).ConfigureAwait(false);
                return;
            }
        }
    }

    private static async Task RunAsync(CommandContext context, PreparedJob job, JobMode mode, bool dryRun, CancellationToken cancellation)
    {
        var fit = context.Machine.Connection.FitToLink(job.Motion.Program!, mode, job.Drawing);
        FindingMessages.Say(context, job.Drawing.FileName, fit.Diagnostics, Severity.Warning);
        var checks = context.Machine.Arming.Armed?.Checklist;
        await JobStart.RunAsync(context, job, checks, options => context.Machine.Runs.RunAsync(job, fit.Program, address => options(JobStart.Options(context, job, address, mode, dryRun)), cancellation), simulated: false).ConfigureAwait(false);
    }
}

/// <summary>CNCSIM: Runs the drawing on a simulated controller and says how well it was cut; no machine moves.</summary>
internal sealed class CncSimCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCSIM", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var job = await JobStart.PrepareAsync(context, JobMode.Stream).ConfigureAwait(false);
        await JobStart.RunAsync(context, job, checks: null, options => context.Machine.Runs.SimulateAsync(job, job.Motion.Program!, address => options(JobStart.Options(context, job, address, JobMode.Stream, dryRun: false) with { Resume = null }), cancellation), simulated: true).ConfigureAwait(false);
    }
}
