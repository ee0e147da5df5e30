using Engraver.Core.Posts;
using Engraver.Workbench.Verification;
using Spectre.Console;

namespace Engraver.Cli.Output;

/// <summary>The progress of a verification: a bar on a terminal, nothing where the output goes to a file or a program.</summary>
internal static class VerifyProgressBar
{
    public static Task<T> ShowAsync<T>(bool quiet, Func<IProgress<ReplayProgress>?, Task<T>> verify)
    {
        if (quiet || Console.IsErrorRedirected) return verify(null);
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        return console.Progress()
            .AutoClear(true)
            .HideCompleted(false)
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn())
            .StartAsync(context => verify(new Bar(context.AddTask(Wording.Get("VerifyProgressBar.Reading"), maxValue: 1.0))));
    }

    private sealed class Bar(ProgressTask task) : IProgress<ReplayProgress>
    {
        public void Report(ReplayProgress value)
        {
            task.Value = value.Fraction;
            task.Description = Wording.Get("VerifyProgressBar.ProgramMachineTime", value.Chunk, value.Chunks, value.MachineTime.TotalSeconds);
        }
    }
}
