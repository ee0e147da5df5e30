using Engraver.Cli.Output;

namespace Engraver.Cli;

/// <summary>Ends the program after an unhandled exception on a background thread (a timer or the thread pool). The runtime would otherwise end the process with
/// a signal (exit 134) and without a report.</summary>
internal sealed class UnhandledExceptionHandler(string[] args, TextWriter error, Action<int> exit)
{
    private int _ended;

    public static void Install(string[] args)
    {
        var resort = new UnhandledExceptionHandler(args, Console.Error, Environment.Exit);
        AppDomain.CurrentDomain.UnhandledException += (_, failure) => resort.Handle(failure.ExceptionObject as Exception ?? new InvalidOperationException(failure.ExceptionObject.ToString()));
    }

    /// <summary>Writes the error and the path of the report, then ends the program. Only the first call has an effect.</summary>
    public void Handle(Exception bug)
    {
        if (Interlocked.Exchange(ref _ended, 1) != 0) return;
        error.WriteLine($"engraver: {CrashReport.Write(bug, args)}");
        exit(ExitCode.InternalError);
    }
}
