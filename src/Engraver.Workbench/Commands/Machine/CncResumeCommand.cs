using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCRESUME: Resumes a held job. Without one it selects what START cuts: the rest of an interrupted job by its journal, the contours from one on, or
/// the whole drawing again.</summary>
internal sealed class CncResumeCommand : ICommand
{
    /// <summary>Name of the last lead-in length.</summary>
    private const string LeadIn = "CNCRESUME";

    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("Contour", "Whole", "Leadin", "Origin");

    public CommandInfo Info { get; } = new("CNCRESUME", CommandGroup.Machine) { StartsMotion = true, IsAllowedDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Controls.ResumeJob())
        {
            context.WriteMessage(Wording.Get("CncResume.Resuming"));
            return;
        }

        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Usage, Wording.Get("CncResume.NothingHeld"));
        if (context.Machine.Connection.Description is null) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        _ = context.Drawing;
        var atOrigin = false;
        var answer = await AskAsync(context).ConfigureAwait(false);
        while (answer is Answer<string>.SelectedOption { Option: "Leadin" or "Origin" } chosen)
        {
            if (chosen.Option == "Leadin") await AskLeadInAsync(context).ConfigureAwait(false);
            else context.WriteMessage(Wording.Get("CncResume.AtOrigin"));
            atOrigin |= chosen.Option == "Origin";
            answer = await AskAsync(context).ConfigureAwait(false);
        }

        if (answer is Answer<string>.SelectedOption { Option: "Whole" }) context.Machine.Runs.ChoosePart(null);
        else if (answer is Answer<string>.Value { Result: var journal }) await FromJournalAsync(context, journal, atOrigin, cancellation).ConfigureAwait(false);
        else await FromContourAsync(context).ConfigureAwait(false);
        if (context.Machine.Runs.Part is null) context.WriteMessage(Wording.Get("CncResume.Whole"), MessageKind.Result);
    }

    private static async Task AskLeadInAsync(CommandContext context)
    {
        var length = await context.ValueAsync(new NumberPrompt(Wording.Get("CncResume.EnterLeadIn")) { Min = 0.0, Max = ResumeRequest.MaxLeadInMm, Default = NumberPrompt.Format(LeadInOf(context)) }).ConfigureAwait(false);
        context.Remember(LeadIn, NumberPrompt.Format(length));
    }

    private static Task<Answer<string>> AskAsync(CommandContext context) =>
        context.AskAsync(new TextPrompt(Wording.Get("CncResume.EnterJournal", LeadInOf(context))) { Options = s_options, Default = context.Machine.Runs.LastRun?.Journal });

    /// <summary>Length of the path before the resume position that is cut again, mm.</summary>
    private static double LeadInOf(CommandContext context) => context.LastValue(LeadIn) is { } kept ? double.Parse(kept, CultureInfo.InvariantCulture) : ResumeRequest.DefaultLeadInMm;

    private static async Task FromContourAsync(CommandContext context)
    {
        var job = await JobStart.PrepareAsync(context, context.Driver.DefaultStrategy).ConfigureAwait(false);
        var program = job.Motion.Program!;
        var contour = (int)await context.ValueAsync(new NumberPrompt(Wording.Get("CncResume.EnterContour", program.Strokes.Count)) { IsInteger = true, Min = 1, Max = program.Strokes.Count }).ConfigureAwait(false);
        Choose(context, program, new JobPart(new ResumeRequest { Stroke = contour - 1 }, ResumePoint.ToStroke(program, contour - 1), null, context.Drawing, context.Document.Current.Settings));
    }

    private static async Task FromJournalAsync(CommandContext context, string journal, bool atOrigin, CancellationToken cancellation)
    {
        var strategy = context.Driver.DefaultStrategy;
        var (job, program, found) = await FindAsync(context, strategy, journal, cancellation).ConfigureAwait(false);
        if (found is { Refusal: not null, Strategy: { } begun } && begun != strategy) (job, program, found) = await FindAsync(context, begun, journal, cancellation).ConfigureAwait(false);
        if (JournalSettings.ResumeRefusal(found, job) is { } why) throw new CommandException(CommandFailure.Refused, PreparationRules.NotResumed.At(default, journal, why).Message);
        if (found.IsUnsealed) context.WriteMessage(PreparationRules.JournalUnsealed.At(default, journal).Message, MessageKind.Warning);
        if (found.Strategy is { } known) context.Remember("CNCARM", known.Keyword);
        Choose(context, program, new JobPart(new ResumeRequest { Journal = journal, LeadInMm = LeadInOf(context), AtOrigin = atOrigin }, found.Place, found.Strategy, context.Drawing, context.Document.Current.Settings) { Plate = job.Plate });
    }

    private static async Task<(PreparedJob Job, MotionProgram Program, ResumePosition Found)> FindAsync(CommandContext context, ExecutionStrategy strategy, string journal, CancellationToken cancellation)
    {
        var job = await JobStart.PrepareAsync(context, strategy, PlateOf(context, journal)).ConfigureAwait(false);
        var program = context.Machine.Connection.FitToLink(job.Motion.Program!, strategy, job.Drawing).Program;
        return (job, program, await context.Machine.Runs.FindResumeAsync(program, strategy, journal, cancellation).ConfigureAwait(false));
    }

    /// <summary>The plate of the interrupted run; the next one where its journal has none, which is then a difference.</summary>
    private static Plate? PlateOf(CommandContext context, string journal) =>
        context.Plates.StateOf(context.Document.Current).Fields is null ? null : JournalPlate.Read(journal) ?? PlateStart.Take(context);

    private static void Choose(CommandContext context, MotionProgram program, JobPart part)
    {
        context.Machine.Runs.ChoosePart(part);
        context.WriteMessage(Wording.Get("CncResume.Chosen", part.Shown.Segments, program.SegmentCount), MessageKind.Result);
    }
}
