using Engraver.Core.Machines;
using Spectre.Console;

namespace Engraver.Cli.Output;

/// <summary>The progress of a run: a bar on a terminal, nothing where the output goes to a file or a program.</summary>
internal static class RunProgressBar
{
    public static Task<T> ShowAsync<T>(bool quiet, MotionProgram program, Func<IProgress<JobProgress>?, Task<T>> run)
    {
        if (quiet || Console.IsErrorRedirected) return run(null);
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        return console.Progress()
            .AutoClear(true)
            .HideCompleted(false)
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn())
            .StartAsync(context => run(new Bar(context.AddTask(Wording.Get("RunProgressBar.Connecting"), maxValue: Math.Max(1, program.SegmentCount)), program.Strokes.Count)));
    }

    private sealed class Bar(ProgressTask task, int strokes) : IProgress<JobProgress>
    {
        public void Report(JobProgress value)
        {
            task.Value = value.SegmentsExecuted;
            task.Description = Wording.Get(value.ToolOn ? "RunProgressBar.ToolOn" : "RunProgressBar.ToolOff", value.Stroke + 1, strokes, value.Seconds);
        }
    }
}
