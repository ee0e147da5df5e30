using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCHOLD: Feed hold of the job: it decelerates on its path, then the tool is switched off or raised. CNCJOG may move the machine meanwhile. Never
/// asks.</summary>
internal sealed class CncHoldCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCHOLD", CommandGroup.Machine) { Transparent = true, HeardDuringJob = true };

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (!context.Machine.Controls.HoldJob()) throw new CommandException(CommandFailure.Usage, Wording.Get("CncHold.NoJobRuns"));
        context.Say(Wording.Get("CncHold.Holding"));
        return Task.CompletedTask;
    }
}

/// <summary>CNCRESUME: Resumes a held job. Without one it selects what START cuts: the rest of an interrupted job by its journal, the contours from one on, or
/// the whole drawing again.</summary>
internal sealed class CncResumeCommand : ICommand
{
    /// <summary>Name of the last lead-in length.</summary>
    private const string LeadIn = "CNCRESUME";

    private static readonly IReadOnlyList<Keyword> s_ways = Keyword.List("Contour", "Whole", "Leadin", "Origin");

    public CommandInfo Info { get; } = new("CNCRESUME", CommandGroup.Machine) { StartsMotion = true, HeardDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Controls.ResumeJob())
        {
            context.Say(Wording.Get("CncResume.Resuming"));
            return;
        }

        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Usage, Wording.Get("CncResume.NothingHeld"));
        if (context.Machine.Connection.Description is null) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        _ = context.Drawing;
        var atOrigin = false;
        var answer = await AskAsync(context).ConfigureAwait(false);
        while (answer is Answer<string>.Chosen { Option: "Leadin" or "Origin" } chosen)
        {
            if (chosen.Option == "Leadin") await AskLeadInAsync(context).ConfigureAwait(false);
            else context.Say(Wording.Get("CncResume.AtOrigin"));
            atOrigin |= chosen.Option == "Origin";
            answer = await AskAsync(context).ConfigureAwait(false);
        }

        if (answer is Answer<string>.Chosen { Option: "Whole" }) context.Machine.Runs.ChoosePart(null);
        else if (answer is Answer<string>.Value { Of: var journal }) await FromJournalAsync(context, journal, atOrigin, cancellation).ConfigureAwait(false);
        else await FromContourAsync(context).ConfigureAwait(false);
        if (context.Machine.Runs.Part is null) context.Say(Wording.Get("CncResume.Whole"), MessageKind.Result);
    }

    private static async Task AskLeadInAsync(CommandContext context)
    {
        var length = await context.ValueAsync(new NumberPrompt(Wording.Get("CncResume.EnterLeadIn")) { Least = 0.0, Most = ResumeRequest.LongestLeadInMm, Default = NumberPrompt.Show(LeadInOf(context)) }).ConfigureAwait(false);
        context.Remember(LeadIn, NumberPrompt.Show(length));
    }

    private static Task<Answer<string>> AskAsync(CommandContext context) =>
        context.AskAsync(new TextPrompt(Wording.Get("CncResume.EnterJournal", LeadInOf(context))) { Options = s_ways, Default = context.Machine.Runs.LastRun?.Journal });

    /// <summary>Length of the path before the resume position that is cut again, mm.</summary>
    private static double LeadInOf(CommandContext context) => context.Remembered(LeadIn) is { } kept ? double.Parse(kept, CultureInfo.InvariantCulture) : ResumeRequest.UsualLeadInMm;

    private static async Task FromContourAsync(CommandContext context)
    {
        var job = await JobStart.PrepareAsync(context, context.Driver.DefaultStrategy).ConfigureAwait(false);
        var program = job.Motion.Program!;
        var contour = (int)await context.ValueAsync(new NumberPrompt(Wording.Get("CncResume.EnterContour", program.Strokes.Count)) { Whole = true, Least = 1, Most = program.Strokes.Count }).ConfigureAwait(false);
        Choose(context, program, new JobPart(new ResumeRequest { Stroke = contour - 1 }, JobBeginning.ToStroke(program, contour - 1), null, context.Drawing, context.Document.Current.Settings));
    }

    private static async Task FromJournalAsync(CommandContext context, string journal, bool atOrigin, CancellationToken cancellation)
    {
        var strategy = context.Driver.DefaultStrategy;
        var (job, program, found) = await FindAsync(context, strategy, journal, cancellation).ConfigureAwait(false);
        if (found is { Refusal: not null, Strategy: { } begun } && begun != strategy) (job, program, found) = await FindAsync(context, begun, journal, cancellation).ConfigureAwait(false);
        if (JobWords.WhyNotResumed(found, job) is { } why) throw new CommandException(CommandFailure.Refused, PreparationRules.NotResumed.At(default, journal, why).Message);
        if (found.IsUnsealed) context.Say(PreparationRules.JournalUnsealed.At(default, journal).Message, MessageKind.Warning);
        if (found.Strategy is { } known) context.Remember("CNCARM", known.Keyword);
        Choose(context, program, new JobPart(new ResumeRequest { Journal = journal, LeadInMm = LeadInOf(context), AtOrigin = atOrigin }, found.Place, found.Strategy, context.Drawing, context.Document.Current.Settings));
    }

    private static async Task<(PreparedJob Job, MotionProgram Program, ResumePlace Found)> FindAsync(CommandContext context, ExecutionStrategy strategy, string journal, CancellationToken cancellation)
    {
        var job = await JobStart.PrepareAsync(context, strategy).ConfigureAwait(false);
        var program = context.Machine.Connection.FitToLink(job.Motion.Program!, strategy, job.Drawing).Program;
        return (job, program, await context.Machine.Runs.FindResumeAsync(program, strategy, journal, cancellation).ConfigureAwait(false));
    }

    private static void Choose(CommandContext context, MotionProgram program, JobPart part)
    {
        context.Machine.Runs.ChoosePart(part);
        context.Say(Wording.Get("CncResume.Chosen", part.Shown.Segments, program.SegmentCount), MessageKind.Result);
    }
}

/// <summary>CNCOVERRIDE: Changes feed or rapid speed of the running job and of the following ones, in percent of the plan.</summary>
internal sealed class CncOverrideCommand : ICommand
{
    private const double Percent = 100.0;

    public CommandInfo Info { get; } = new("CNCOVERRIDE", CommandGroup.Machine) { Transparent = true, HeardDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var status = context.Machine.Status;
        var (slowest, fastest) = (JobControl.FeedRange.Slowest * Percent, JobControl.FeedRange.Fastest * Percent);
        var feed = await AskAsync(context, Wording.Get("CncOverride.EnterFeed", slowest, fastest), status.FeedRatio, JobControl.FeedRange, Keyword.List("Rapid")).ConfigureAwait(false);
        var rapid = default(double?);
        (slowest, fastest) = (JobControl.RapidRange.Slowest * Percent, JobControl.RapidRange.Fastest * Percent);
        if (feed is null) rapid = await AskAsync(context, Wording.Get("CncOverride.EnterRapid", slowest, fastest), status.RapidRatio, JobControl.RapidRange, []).ConfigureAwait(false);
        var set = context.Machine.Controls.Override(feed, rapid);
        context.Say(Wording.Get("CncOverride.Set", set.Feed * Percent, set.Rapid * Percent), MessageKind.Result);
    }

    /// <returns>The factor; null if the keyword was chosen.</returns>
    private static async Task<double?> AskAsync(CommandContext context, string instruction, double now, SpeedRange range, IReadOnlyList<Keyword> options)
    {
        var prompt = new NumberPrompt(instruction)
        {
            Options = options,
            Default = (now * Percent).ToString("0.##", CultureInfo.InvariantCulture),
            Least = range.Slowest * Percent,
            Most = range.Fastest * Percent,
        };
        var answer = await context.AskAsync(prompt).ConfigureAwait(false);
        return answer is Answer<double>.Value { Of: var percent } ? percent / Percent : null;
    }
}
