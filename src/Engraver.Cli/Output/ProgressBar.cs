using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Workbench.Sending;
using Spectre.Console;

namespace Engraver.Cli.Output;

/// <summary>The progress of a long operation: a bar on a terminal, nothing where standard error is redirected or the user asked for no messages.</summary>
internal static class ProgressBar
{
    public static Task<T> OfRunAsync<T>(bool quiet, MotionProgram program, Func<IProgress<JobProgress>?, Task<T>> run)
    {
        var strokes = program.Strokes.Count;
        return ShowAsync(quiet, Wording.Get("ProgressBar.Connecting"), Math.Max(1, program.SegmentCount), run, progress =>
            (progress.SegmentsExecuted, Wording.Get(progress.ToolOn ? "ProgressBar.ToolOn" : "ProgressBar.ToolOff", progress.Stroke + 1, strokes, progress.Seconds)));
    }

    public static Task<T> OfSendingAsync<T>(bool quiet, int lines, Func<IProgress<SendProgress>?, Task<T>> send) =>
        ShowAsync(quiet, Wording.Get("ProgressBar.Sending"), lines, send, progress => (progress.Lines, Wording.Get("ProgressBar.Lines", progress.Lines, progress.TotalLines)));

    public static Task<T> OfVerificationAsync<T>(bool quiet, Func<IProgress<ReplayProgress>?, Task<T>> verify) =>
        ShowAsync(quiet, Wording.Get("ProgressBar.Reading"), 1.0, verify, progress =>
            (progress.Fraction, Wording.Get("ProgressBar.ProgramMachineTime", progress.Chunk, progress.Chunks, progress.MachineTime.TotalSeconds)));

    /// <param name="quiet">True for no bar.</param>
    /// <param name="start">The text before the first report.</param>
    /// <param name="max">The value of a full bar.</param>
    /// <param name="operation">The operation; it reports to its argument, which is null without a bar.</param>
    /// <param name="show">The value and the text of a report.</param>
    private static Task<TResult> ShowAsync<TProgress, TResult>(bool quiet, string start, double max, Func<IProgress<TProgress>?, Task<TResult>> operation, Func<TProgress, (double Value, string Text)> show)
    {
        if (quiet || Console.IsErrorRedirected) return operation(null);
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        return console.Progress()
            .AutoClear(true)
            .HideCompleted(false)
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn())
            .StartAsync(context => operation(new Reporter<TProgress>(context.AddTask(start, maxValue: max), show)));
    }

    private sealed class Reporter<T>(ProgressTask task, Func<T, (double Value, string Text)> show) : IProgress<T>
    {
        public void Report(T value) => (task.Value, task.Description) = show(value);
    }
}
