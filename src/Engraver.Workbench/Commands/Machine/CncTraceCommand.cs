using Engraver.Core.Plots;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Settings;
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
                Show(context, await StoredRun.AskAsync(context).ConfigureAwait(false));
                break;
            case "LIst":
                StoredRun.WriteList(context);
                break;
            case "LAst":
                Show(context, StoredRun.LastOf(context));
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

    /// <exception cref="CommandException">A job is running and its own trace is shown.</exception>
    private static void ThrowIfRunning(CommandContext context)
    {
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("CncTrace.JobRuns"));
    }

    private static void Show(CommandContext context, string file)
    {
        ThrowIfRunning(context);
        var run = StoredRun.Read(context, file);
        context.Machine.Runs.ShowRun(run);
        context.View.Change(view => view with { Shown = view.Shown | CanvasLayers.Recorded });
        var measure = MeasureOf(context);
        if (measure == RunMeasure.Following && !run.Trace.HasFollowing) context.WriteMessage(Wording.Get("CncTrace.NoFollowingError"), MessageKind.Warning);
        context.WriteMessage(Wording.Get("CncTrace.Shown", file, RunPlot.Caption(run.Trace, measure)), MessageKind.Result);
    }

    private static async Task ColourAsync(CommandContext context)
    {
        var chosen = await context.ChoiceAsync(Wording.Get("CncTrace.EnterColour"), Keyword.List([.. Enum.GetNames<RunMeasure>()]), MeasureOf(context).ToString()).ConfigureAwait(false);
        context.Settings.Change(settings => settings.WithVariable(SystemVariables.CncTraceColor, (int)Enum.Parse<RunMeasure>(chosen)));
        if (chosen == nameof(RunMeasure.Following) && context.Machine.Runs.Recorded is { Trace.HasFollowing: false }) context.WriteMessage(Wording.Get("CncTrace.NoFollowingError"), MessageKind.Warning);
    }

    private static RunMeasure MeasureOf(CommandContext context) => context.Settings.Current.TraceColour();
}
