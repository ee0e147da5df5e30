using Engraver.Core.Languages;
using Engraver.Core.Plots;
using Engraver.Core.Verification;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCTRACE: Shows the recorded trace of a run over the drawing, and selects the quantity that colours it.</summary>
internal sealed class CncTraceCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCTRACE", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        switch (await context.ChoiceAsync(Wording.Get("CncTrace.EnterOption"), Keyword.List("File", "LIst", "LAst", "Colour", "Off"), "LAst").ConfigureAwait(false))
        {
            case "File":
                Show(context, context.ResolveInputPath(await context.ValueAsync(new FilePrompt(Wording.Get("CncTrace.EnterFile"), new FileRequest("journal", false))).ConfigureAwait(false)));
                break;
            case "LIst":
                List(context);
                break;
            case "LAst":
                Show(context, TraceFile.LastOf(context.Drawing.FileName, context.RunJournalFolder) ?? throw NoRun(context));
                break;
            case "Colour":
                await ColourAsync(context).ConfigureAwait(false);
                break;
            default:
                ThrowIfRunning(context);
                context.Machine.Runs.ShowRun(null);
                break;
        }
    }

    private static CommandException NoRun(CommandContext context) => new(CommandFailure.Usage, Wording.Get("CncTrace.NoRun", Path.GetFileName(context.Drawing.FileName)));

    /// <exception cref="CommandException">A job is running and its own trace is shown.</exception>
    private static void ThrowIfRunning(CommandContext context)
    {
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("CncTrace.JobRuns"));
    }

    private static void List(CommandContext context)
    {
        var kept = TraceFile.AllOf(context.Drawing.FileName, context.RunJournalFolder);
        if (kept.Count == 0) throw NoRun(context);
        context.WriteResult(output =>
        {
            foreach (var journal in kept) output.WriteLine(TraceFile.PathOf(journal));
        });
    }

    private static void Show(CommandContext context, string file)
    {
        ThrowIfRunning(context);
        var job = JobPreparation.Prepare(context.Drawing, context.Document.Current.Settings, context.Driver.DefaultStrategy.Style);
        var trace = Read(file);
        if (!trace.CanBeOf(DrawnFingerprint.Of(job.Analysed.ToSegments()))) throw new CommandException(CommandFailure.Usage, Wording.Get("CncTrace.OtherDrawing", file, Path.GetFileName(context.Drawing.FileName)));
        context.Machine.Runs.ShowRun(new RecordedRun(job, trace));
        context.View.Change(view => view with { Shown = view.Shown | CanvasLayers.Recorded });
        var measure = MeasureOf(context);
        if (measure == RunMeasure.Following && !trace.HasFollowing) context.WriteMessage(Wording.Get("CncTrace.NoFollowingError"), MessageKind.Warning);
        context.WriteMessage(Wording.Get("CncTrace.Shown", file, RunPlot.Caption(trace, measure)), MessageKind.Result);
    }

    /// <exception cref="CommandException">It cannot be read or is not a trace.</exception>
    private static RunTrace Read(string file)
    {
        try
        {
            return TraceFile.Read(file);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or FormatException)
        {
            throw new CommandException(CommandFailure.Usage, Wording.Get("CncTrace.Unreadable", file, SystemErrorText.FromException(unreadable)));
        }
    }

    private static async Task ColourAsync(CommandContext context)
    {
        var chosen = await context.ChoiceAsync(Wording.Get("CncTrace.EnterColour"), Keyword.List([.. Enum.GetNames<RunMeasure>()]), MeasureOf(context).ToString()).ConfigureAwait(false);
        context.Settings.Change(settings => settings.WithVariable(SystemVariables.CncTraceColor, (int)Enum.Parse<RunMeasure>(chosen)));
        if (chosen == nameof(RunMeasure.Following) && context.Machine.Runs.Recorded is { Trace.HasFollowing: false }) context.WriteMessage(Wording.Get("CncTrace.NoFollowingError"), MessageKind.Warning);
    }

    private static RunMeasure MeasureOf(CommandContext context) => context.Settings.Current.TraceColour();
}
