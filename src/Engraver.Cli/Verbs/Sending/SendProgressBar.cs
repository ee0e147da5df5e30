using Engraver.Workbench.Sending;
using Spectre.Console;

namespace Engraver.Cli.Verbs.Sending;

/// <summary>The progress of a transmission: a bar on a terminal, nothing where the output goes to a file or a program.</summary>
internal static class SendProgressBar
{
    public static Task<T> ShowAsync<T>(bool silent, int lines, Func<IProgress<SendProgress>?, Task<T>> run)
    {
        if (silent || Console.IsErrorRedirected) return run(null);
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        return console.Progress()
            .AutoClear(true)
            .HideCompleted(false)
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn())
            .StartAsync(context => run(new Bar(context.AddTask(Wording.Get("SendProgressBar.Sending"), maxValue: lines))));
    }

    private sealed class Bar(ProgressTask task) : IProgress<SendProgress>
    {
        public void Report(SendProgress value)
        {
            task.Value = value.Lines;
            task.Description = Wording.Get("SendProgressBar.Lines", value.Lines, value.AllLines);
        }
    }
}
